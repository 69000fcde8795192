// SPDX-License-Identifier: MIT
#include "tests/architecture/rules.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace architecture {

namespace {

constexpr std::size_t kMostComponents = 20;
constexpr std::size_t kMostLines = 400;
constexpr std::size_t kMostFunctionLines = 60;

// Lowest first: a folder may include those before it.
const std::vector<std::string> kCoreFolders{"core/processor",      "core/numeric",      "core/text",
                                            "core/geometry",       "core/hand",         "core/demo_hand",
                                            "core/contour",        "core/distance",     "core/fitting",
                                            "core/detection",      "core/segmentation", "core/subject",
                                            "core/annotation",     "core/rig",          "core/labelling",
                                            "core/simulation",     "core/benchmark",    "core/benchmark/comparison",
                                            "core/io/files",       "core/io/hdf5",      "core/io/matlab",
                                            "core/io/calibration", "core/io/hands",     "core/io/store",
                                            "core/io/footage",     "core/io/dataset",   "core/io/derived",
                                            "core/io/formats",     "core/io/detector",  "core/io/segmentation",
                                            "core/io/demo",        "core/io/import",    "core/io/benchmark"};
const std::vector<std::string> kWidgetFolders{"widgets/text",
                                              "widgets/document",
                                              "widgets/jobs",
                                              "widgets/jobs/benchmark",
                                              "widgets/session",
                                              "widgets/models",
                                              "widgets/views",
                                              "widgets/views/camera",
                                              "widgets/views/scene",
                                              "widgets/presenters",
                                              "widgets/presenters/inspect",
                                              "widgets/panels",
                                              "widgets/panels/compare",
                                              "widgets/panels/quality",
                                              "widgets/panels/review",
                                              "widgets/panels/silhouettes",
                                              "widgets/workspaces"};
const std::vector<std::string> kTops{"core", "widgets", "app"};

/// A library: how its headers look, and the paths that may include them.
struct Fence {
    std::string library;
    std::regex header;
    std::regex allowed;
};

const std::vector<Fence>& fences() {
    static const std::vector<Fence> list{
        {"Qt", std::regex("Q[A-Z].*|Qt[A-Z].*|q[a-z]+\\.h|qt[a-z]+\\.h"),
         std::regex("(widgets/|app/desktop/|tests/).*")},
        {"VTK", std::regex("vtk.*|QVTK.*"),
         std::regex("(widgets/views/(scene/|curve|private_display)|app/desktop/main|tests/).*")},
        {"assimp", std::regex("assimp/.*"), std::regex("core/io/(hands/off_mesh|import/gltf)[a-z_]*\\.cpp|tests/.*")},
        {"OpenCV", std::regex("opencv2?/.*"),
         std::regex(
             "(core/(contour|distance|fitting|detection|segmentation|labelling|simulation|benchmark|io)/|widgets/|app/"
             "|tests/).*")},
        {"SQLite", std::regex("sqlite3\\.h|SQLiteCpp/.*"), std::regex("(core/io/store/|tests/).*")},
        {"JSON", std::regex("nlohmann/.*|valijson/.*"), std::regex("(core/io/|app/|tests/).*")},
        {"TOML", std::regex("toml\\+\\+/.*"), std::regex("core/io/calibration/.*")},
        {"libav", std::regex("lib(av|sw)[a-z]+/.*"), std::regex("core/io/footage/.*")},
        {"matio", std::regex("matio\\.h"), std::regex("core/io/matlab/.*|tests/.*")},
        {"zlib", std::regex("zlib\\.h"), std::regex("core/io/(detector|matlab)/.*|tests/.*")},
        {"HDF5", std::regex("hdf5\\.h"), std::regex("core/io/hdf5/.*|tests/.*")},
        {"CLI11", std::regex("CLI/.*"), std::regex("app/.*")},
        {"spdlog", std::regex("spdlog/.*"), std::regex("(widgets/|app/).*")},
        {"Ceres", std::regex("ceres/.*"), std::regex("(core/rig/|tests/).*")}};
    return list;
}

std::string at(const SourceFile& file, int line, const std::string& what) {
    return file.path + ":" + std::to_string(line) + ": " + what;
}

int rank(const std::vector<std::string>& order, const std::string& folder) {
    const auto found = std::find(order.begin(), order.end(), folder);
    return found == order.end() ? -1 : static_cast<int>(found - order.begin());
}

std::string parentFolder(const std::string& path) {
    return path.substr(0, path.rfind('/'));
}

std::string folderOf(const std::string& path, int depth) {
    return SourceFile{path, {}, {}}.folder(depth);
}

/// Why one include goes the wrong way, or nothing.
std::string directionProblem(const std::string& from, const std::string& to) {
    const std::string topFrom = folderOf(from, 1), topTo = folderOf(to, 1);
    if (topFrom == "tests" || rank(kTops, topTo) < 0)
        return topTo == "tests" && topFrom != "tests" ? "the product includes a test" : "";
    if (rank(kTops, topTo) > rank(kTops, topFrom))
        return topFrom + " includes " + topTo;
    if (topFrom == "app" && topTo == "app" && folderOf(from, 2) != folderOf(to, 2))
        return folderOf(from, 2) + " includes " + folderOf(to, 2);
    if (folderOf(from, 2) == "app/batch" && topTo == "widgets")
        return "app/batch includes widgets";
    const std::string folderFrom = parentFolder(from), folderTo = parentFolder(to);
    for (const auto& order : {kCoreFolders, kWidgetFolders})
        if (rank(order, folderFrom) >= 0 && rank(order, folderTo) > rank(order, folderFrom))
            return folderFrom + " includes " + folderTo;
    return "";
}

/// A header and its source together: the path without its extension.
std::string componentOf(const std::string& path) {
    return path.substr(0, path.rfind('.'));
}

/// Depth-first search for a way back to a component that is still being visited.
class CycleSearch {
public:
    explicit CycleSearch(const std::vector<SourceFile>& files) {
        for (const SourceFile& file : files) {
            std::set<std::string>& included = m_components[componentOf(file.path)];
            for (const Include& include : file.includes)
                if (include.isQuoted && componentOf(include.path) != componentOf(file.path))
                    included.insert(componentOf(include.path));
        }
    }

    Violations run() {
        for (const auto& [component, included] : m_components)
            visit(component);
        return m_violations;
    }

private:
    void visit(const std::string& component) {
        const auto found = m_components.find(component);
        if (found == m_components.end() || m_done.count(component) > 0)
            return;
        const auto open = std::find(m_open.begin(), m_open.end(), component);
        if (open != m_open.end()) {
            std::string circle;
            for (auto i = open; i != m_open.end(); ++i)
                circle += *i + " -> ";
            m_violations.push_back(circle + component);
            return;
        }
        m_open.push_back(component);
        for (const std::string& included : found->second)
            visit(included);
        m_open.pop_back();
        m_done.insert(component);
    }

    std::map<std::string, std::set<std::string>> m_components; ///< and what each includes
    std::vector<std::string> m_open;
    std::set<std::string> m_done;
    Violations m_violations;
};

std::size_t indentation(const std::string& line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

/// Whether a line begins a class, a namespace, a loop or the like.
bool isOtherBlock(const std::string& line) {
    static const std::regex other(
        "\\s*(namespace|class|struct|enum|union|extern|if|else|for|while|do|switch|try|catch|return|case)\\b.*");
    return std::regex_match(line, other);
}

/// Whether a line that ends with `{` opens the body of a function (and not such a block or a list).
bool opensFunction(const std::string& line) {
    static const std::regex list(".*=\\s*\\{|.*\\w\\{");
    return line.ends_with("{") && !isOtherBlock(line) && !std::regex_match(line, list);
}

/// Where the header begins whose body opens in line `open`: above wrapped parameters and a constructor's initialisers.
/// The line itself for a lambda.
std::size_t firstLineOfHeader(const std::vector<std::string>& lines, std::size_t open) {
    const auto continues = [&](std::size_t line) {
        const std::size_t indent = indentation(lines[line]);
        return indent > 4 || (indent == 4 && (lines[line][indent] == ':' || lines[line][indent] == ','));
    };
    if (lines[open].find('[') != std::string::npos)
        return open;
    std::size_t start = open;
    while (start > 0 && continues(start))
        --start;
    return start;
}

} // namespace

Violations wrongDirections(const std::vector<SourceFile>& files) {
    Violations violations;
    for (const SourceFile& file : files) {
        for (const Include& include : file.includes) {
            const std::string problem = include.isQuoted ? directionProblem(file.path, include.path) : "";
            if (!problem.empty())
                violations.push_back(at(file, include.line, problem + " (" + include.path + ")"));
        }
    }
    return violations;
}

Violations includeCycles(const std::vector<SourceFile>& files) {
    return CycleSearch(files).run();
}

Violations brokenFences(const std::vector<SourceFile>& files) {
    Violations violations;
    for (const SourceFile& file : files) {
        for (const Include& include : file.includes) {
            for (const Fence& fence : fences()) {
                const bool isOfLibrary = !include.isQuoted && std::regex_match(include.path, fence.header);
                if (isOfLibrary && !std::regex_match(file.path, fence.allowed) && !file.path.starts_with("tests/")) {
                    violations.push_back(
                        at(file, include.line, fence.library + " is not used here (" + include.path + ")"));
                }
            }
        }
    }
    return violations;
}

Violations wholeSessions(const std::vector<SourceFile>& files) {
    static const std::regex builders("widgets/session/window_session\\.cpp|widgets/workspaces/workspaces\\.(h|cpp)|"
                                     "app/desktop/.*|tests/.*");
    Violations violations;
    for (const SourceFile& file : files)
        for (const Include& include : file.includes)
            if (include.path == "widgets/session/window_session.h" && !std::regex_match(file.path, builders))
                violations.push_back(at(file, include.line, "takes the whole session instead of the parts it needs"));
    return violations;
}

Violations unknownIncludes(const std::vector<SourceFile>& files) {
    std::set<std::string> paths;
    for (const SourceFile& file : files)
        paths.insert(file.path);
    static const std::regex generated(".*\\.moc|moc_.*|ui_.*");
    Violations violations;
    for (const SourceFile& file : files) {
        for (const Include& include : file.includes) {
            if (include.isQuoted && paths.count(include.path) == 0 && !std::regex_match(include.path, generated)) {
                violations.push_back(at(file, include.line,
                                        "\"" + include.path + "\" is not a file of the project, named from its root"));
            }
        }
    }
    return violations;
}

Violations crowdedFolders(const std::vector<SourceFile>& files) {
    std::map<std::string, std::set<std::string>> folders;
    for (const SourceFile& file : files)
        folders[parentFolder(file.path)].insert(componentOf(file.path));
    Violations violations;
    for (const auto& [folder, components] : folders) {
        if (folder != "app/batch" && components.size() > kMostComponents) { // which has one file per command
            violations.push_back(folder + ": " + std::to_string(components.size()) + " components, at most " +
                                 std::to_string(kMostComponents));
        }
    }
    return violations;
}

Violations unrankedFolders(const std::vector<SourceFile>& files) {
    std::set<std::string> folders;
    for (const SourceFile& file : files)
        folders.insert(parentFolder(file.path));
    Violations violations;
    for (const std::string& folder : folders)
        if ((folder.starts_with("core/") && rank(kCoreFolders, folder) < 0) ||
            (folder.starts_with("widgets/") && rank(kWidgetFolders, folder) < 0))
            violations.push_back(folder + " has no place in the order of the folders");
    return violations;
}

Violations unnamedFolders(const std::vector<SourceFile>& files, const std::string& text,
                          const std::vector<std::string>& marks) {
    std::set<std::string> folders;
    for (const SourceFile& file : files)
        if (folderOf(file.path, 1) != "tests" && folderOf(file.path, 2) != file.path)
            folders.insert(parentFolder(file.path));
    Violations violations;
    for (const std::string& folder : folders) {
        const std::string name = folder.substr(folder.rfind('/') + 1);
        const bool isNamed = std::any_of(marks.begin(), marks.end(), [&](const std::string& mark) {
            return std::regex_search(text, std::regex(mark + name + "\\b"));
        });
        if (!isNamed)
            violations.push_back(folder + " is not named");
    }
    return violations;
}

Violations longFiles(const std::vector<SourceFile>& files) {
    Violations violations;
    for (const SourceFile& file : files) {
        if (file.lines.size() > kMostLines) {
            violations.push_back(
                at(file, 1, std::to_string(file.lines.size()) + " lines, at most " + std::to_string(kMostLines)));
        }
    }
    return violations;
}

Violations longFunctions(const std::vector<SourceFile>& files) {
    Violations violations;
    for (const SourceFile& file : files) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::size_t start = opensFunction(file.lines[i]) ? firstLineOfHeader(file.lines, i) : i;
            if (indentation(file.lines[start]) > 4 || !opensFunction(file.lines[i]) || isOtherBlock(file.lines[start]))
                continue;
            const std::string closing = std::string(indentation(file.lines[start]), ' ') + "}";
            std::size_t end = i + 1;
            while (end < file.lines.size() && !file.lines[end].starts_with(closing))
                ++end;
            if (end - start + 1 > kMostFunctionLines) {
                violations.push_back(at(file, static_cast<int>(start) + 1,
                                        "a function of " + std::to_string(end - start + 1) + " lines, at most " +
                                            std::to_string(kMostFunctionLines)));
            }
        }
    }
    return violations;
}

Violations unplainWords(const std::vector<SourceFile>& files) {
    static const std::regex unplain(
        "(.*\\W)?(([a-z]+) (is|are) no (?!longer|more|larger|smaller|better|worse).*|"
        "nothing (if|for|where|when|unless|with|without|outside|beyond|behind) .*|(some|any|every)body\\b.*)",
        std::regex::icase);
    static const std::regex plain(".*\\b(there (is|are) no|(do|does|write|writes|change|changes) nothing)\\b.*",
                                  std::regex::icase);
    Violations violations;
    for (const SourceFile& file : files)
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            if (std::regex_match(file.lines[i], unplain) && !std::regex_match(file.lines[i], plain))
                violations.push_back(at(file, static_cast<int>(i) + 1, "not plain words: " + file.lines[i]));
    return violations;
}

Violations untidyFiles(const std::vector<SourceFile>& files) {
    static const std::regex meaningless("(.*/)?(util|utils|common|misc|globals|helpers)(/.*|\\.(h|cpp))");
    Violations violations;
    for (const SourceFile& file : files) {
        if (file.lines.empty() || file.lines.front() != "// SPDX-License-Identifier: MIT")
            violations.push_back(at(file, 1, "the licence line is missing"));
        if (file.isHeader() && std::find(file.lines.begin(), file.lines.end(), "#pragma once") == file.lines.end())
            violations.push_back(at(file, 1, "#pragma once is missing"));
        if (std::regex_match(file.path, meaningless))
            violations.push_back(at(file, 1, "the name says nothing"));
    }
    return violations;
}

} // namespace architecture
