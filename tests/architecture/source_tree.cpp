// SPDX-License-Identifier: MIT
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace architecture {

namespace fs = std::filesystem;

std::string SourceFile::folder(int depth) const {
    std::size_t end = 0;
    for (int i = 0; i < depth; ++i) {
        const std::size_t slash = path.find('/', end == 0 ? 0 : end + 1);
        if (slash == std::string::npos)
            break;
        end = slash;
    }
    return path.substr(0, end);
}

SourceFile parseSource(std::string path, const std::string& text) {
    static const std::regex includeLine("^\\s*#\\s*include\\s*([\"<])([^\">]+)[\">].*");
    SourceFile file;
    file.path = std::move(path);
    std::istringstream stream(text);
    std::smatch match;
    for (std::string line; std::getline(stream, line);) {
        file.lines.push_back(line);
        if (std::regex_match(line, match, includeLine))
            file.includes.push_back({match[2], match[1] == "\"", static_cast<int>(file.lines.size())});
    }
    return file;
}

std::string readText(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

std::vector<SourceFile> readSourceTree(const fs::path& root) {
    std::vector<SourceFile> files;
    for (const char* top : {"core", "widgets", "app", "tests"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
            const std::string extension = entry.path().extension().string();
            if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
                files.push_back(parseSource(fs::relative(entry.path(), root).generic_string(), readText(entry.path())));
        }
    }
    std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

} // namespace architecture
