// SPDX-License-Identifier: MIT
#include <regex>

#include <gtest/gtest.h>

#include "tests/architecture/rules.h"

namespace {

using architecture::parseSource;
using architecture::SourceFile;
using architecture::Violations;

const std::vector<SourceFile>& tree() {
    static const std::vector<SourceFile> files = architecture::readSourceTree(HANDLENS_SOURCE_DIR);
    return files;
}

std::string joined(const Violations& violations) {
    std::string text;
    for (const std::string& violation : violations)
        text += "\n  " + violation;
    return text;
}

#define EXPECT_NO_VIOLATIONS(violations)                                                                               \
    do {                                                                                                               \
        const Violations found = (violations);                                                                         \
        EXPECT_TRUE(found.empty()) << joined(found);                                                                   \
    } while (false)

TEST(Architecture, FindsTheSources) {
    EXPECT_GT(tree().size(), 50u);
}
TEST(Architecture, IncludesPointInTheRightDirection) {
    EXPECT_NO_VIOLATIONS(architecture::wrongDirections(tree()));
}
TEST(Architecture, HasNoCycles) {
    EXPECT_NO_VIOLATIONS(architecture::includeCycles(tree()));
}
TEST(Architecture, LibrariesStayInsideTheirFences) {
    EXPECT_NO_VIOLATIONS(architecture::brokenFences(tree()));
}
TEST(Architecture, PanelsTakePartsOfTheSession) {
    EXPECT_NO_VIOLATIONS(architecture::wholeSessions(tree()));
}
TEST(Architecture, IncludesAreNamedFromTheRoot) {
    EXPECT_NO_VIOLATIONS(architecture::unknownIncludes(tree()));
}
TEST(Architecture, EveryFolderHasItsPlaceInTheOrder) {
    EXPECT_NO_VIOLATIONS(architecture::unrankedFolders(tree()));
}
TEST(Architecture, TheDocumentAndItsDrawingNameEveryFolder) {
    const std::string root = std::string(HANDLENS_SOURCE_DIR) + "/docs/architecture";
    EXPECT_NO_VIOLATIONS(architecture::unnamedFolders(tree(), architecture::readText(root + ".md"), {"`", "/"}));
    std::vector<SourceFile> layers = tree(); // the drawing shows rooms of the layers, no parts of rooms
    std::erase_if(layers, [](const SourceFile& file) {
        return !std::regex_search(file.path, std::regex("^(core|core/io|widgets)/[^/]+/[^/]+$"));
    });
    EXPECT_NO_VIOLATIONS(architecture::unnamedFolders(layers, architecture::readText(root + ".svg"), {">"}));
}
TEST(Architecture, FoldersAreSmall) {
    EXPECT_NO_VIOLATIONS(architecture::crowdedFolders(tree()));
}
TEST(Architecture, FilesAreShort) {
    EXPECT_NO_VIOLATIONS(architecture::longFiles(tree()));
}
TEST(Architecture, FunctionsAreShort) {
    EXPECT_NO_VIOLATIONS(architecture::longFunctions(tree()));
}
TEST(Architecture, CommentsAndMessagesAreInPlainWords) {
    std::vector<SourceFile> product = tree();
    std::erase_if(product, [](const SourceFile& file) { return file.path.starts_with("tests/architecture/"); });
    EXPECT_NO_VIOLATIONS(architecture::unplainWords(product));
}
TEST(Architecture, FilesAreTidy) {
    EXPECT_NO_VIOLATIONS(architecture::untidyFiles(tree()));
}

// The rules themselves: each must catch what it is there for.

/// What a rule says of one made-up file.
template <typename Rule>
Violations judge(Rule rule, const std::string& path, const std::string& text) {
    return rule({parseSource(path, text)});
}

TEST(Rules, CatchIncludesAgainstTheDirection) {
    const auto caught = [](const std::string& path, const std::string& included) {
        return judge(architecture::wrongDirections, path, "#include \"" + included + "\"\n").size() == 1;
    };
    EXPECT_TRUE(caught("core/geometry/a.h", "core/hand/b.h"));
    EXPECT_TRUE(caught("core/numeric/a.cpp", "core/io/files/b.h"));
    EXPECT_TRUE(caught("core/io/files/a.cpp", "core/io/dataset/b.h"));
    EXPECT_TRUE(caught("widgets/panels/a.cpp", "widgets/workspaces/b.h"));
    EXPECT_TRUE(caught("core/io/store/a.cpp", "widgets/document/b.h"));
    EXPECT_TRUE(caught("widgets/views/a.cpp", "widgets/panels/b.h"));
    EXPECT_TRUE(caught("widgets/views/a.cpp", "app/desktop/b.h"));
    EXPECT_TRUE(caught("app/batch/a.cpp", "widgets/views/b.h"));
    EXPECT_TRUE(caught("app/batch/a.cpp", "app/desktop/b.h"));
    EXPECT_TRUE(caught("core/io/store/a.cpp", "tests/support/b.h"));
}

TEST(Rules, LetIncludesPassThatGoDown) {
    const auto passes = [](const std::string& path, const std::string& included) {
        return judge(architecture::wrongDirections, path, "#include \"" + included + "\"\n").empty();
    };
    EXPECT_TRUE(passes("core/hand/a.h", "core/geometry/b.h"));
    EXPECT_TRUE(passes("core/geometry/a.h", "core/error.h"));
    EXPECT_TRUE(passes("widgets/panels/a.h", "widgets/views/b.h"));
    EXPECT_TRUE(passes("widgets/views/a.h", "core/io/store/b.h"));
    EXPECT_TRUE(passes("app/desktop/a.h", "widgets/panels/b.h"));
    EXPECT_TRUE(passes("tests/core/io/a.cpp", "core/io/b.h"));
}

TEST(Rules, CatchCycles) {
    const std::vector<SourceFile> circle{parseSource("core/hand/a.h", "#include \"core/hand/b.h\"\n"),
                                         parseSource("core/hand/b.h", "#include \"core/hand/c.h\"\n"),
                                         parseSource("core/hand/c.h", "#include \"core/hand/a.h\"\n")};
    ASSERT_EQ(architecture::includeCycles(circle).size(), 1u);
    EXPECT_EQ(architecture::includeCycles(circle).front(), "core/hand/a -> core/hand/b -> core/hand/c -> core/hand/a");
    const std::vector<SourceFile> diamond{
        parseSource("core/hand/a.h", "#include \"core/hand/b.h\"\n#include \"core/hand/c.h\"\n"),
        parseSource("core/hand/b.h", "#include \"core/hand/c.h\"\n"), parseSource("core/hand/c.h", "")};
    EXPECT_TRUE(architecture::includeCycles(diamond).empty());
    const std::vector<SourceFile> throughSources{
        parseSource("core/hand/a.cpp", "#include \"core/hand/a.h\"\n#include \"core/hand/b.h\"\n"),
        parseSource("core/hand/b.h", ""), parseSource("core/hand/b.cpp", "#include \"core/hand/a.h\"\n")};
    EXPECT_EQ(architecture::includeCycles(throughSources).size(), 1u) << "header and source are one component";
}

TEST(Rules, CatchLibrariesOutsideTheirFence) {
    const auto caught = [](const std::string& path, const std::string& header) {
        return judge(architecture::brokenFences, path, "#include <" + header + ">\n").size() == 1;
    };
    EXPECT_TRUE(caught("core/io/a.cpp", "QString"));
    EXPECT_TRUE(caught("core/io/a.cpp", "QtCore/QString"));
    EXPECT_TRUE(caught("app/batch/a.cpp", "QApplication"));
    EXPECT_TRUE(caught("widgets/panels/a.cpp", "vtkActor.h"));
    EXPECT_TRUE(caught("widgets/views/camera/camera_view.cpp", "QVTKOpenGLNativeWidget.h"));
    EXPECT_TRUE(caught("core/hand/a.cpp", "assimp/scene.h"));
    EXPECT_TRUE(caught("core/geometry/a.h", "opencv2/core.hpp"));
    EXPECT_TRUE(caught("core/annotation/a.cpp", "SQLiteCpp/SQLiteCpp.h"));
    EXPECT_TRUE(caught("core/fitting/a.cpp", "ceres/ceres.h"));
    EXPECT_FALSE(caught("widgets/views/scene/scene_view.cpp", "vtkActor.h"));
    EXPECT_FALSE(caught("core/contour/a.h", "opencv2/core.hpp"));
    EXPECT_FALSE(caught("core/io/hands/off_mesh.cpp", "assimp/scene.h"));
    EXPECT_FALSE(caught("core/io/a.cpp", "queue"));
}

TEST(Rules, CatchPanelsThatTakeTheWholeSession) {
    const std::string include = "#include \"widgets/session/window_session.h\"\n";
    EXPECT_EQ(judge(architecture::wholeSessions, "widgets/panels/a.h", include).size(), 1u);
    EXPECT_EQ(judge(architecture::wholeSessions, "widgets/workspaces/a_page.h", include).size(), 1u);
    EXPECT_EQ(judge(architecture::wholeSessions, "widgets/workspaces/workspaces.h", include).size(), 0u);
    EXPECT_EQ(judge(architecture::wholeSessions, "app/desktop/main_window.h", include).size(), 0u);
}

TEST(Rules, CatchIncludesThatAreNotNamedFromTheRoot) {
    EXPECT_EQ(judge(architecture::unknownIncludes, "core/hand/a.cpp", "#include \"b.h\"\n").size(), 1u);
    EXPECT_EQ(judge(architecture::unknownIncludes, "core/hand/a.h", "#include \"core/hand/a.h\"\n").size(), 0u);
}

TEST(Rules, CatchLongFilesAndFunctions) {
    std::string body;
    for (int i = 0; i < 58; ++i)
        body += "    call();\n";
    const std::string just = "void f(int x) {\n" + body + "}\n",
                      tooLong = "void f(int x) {\n" + body + "    call();\n}\n";
    EXPECT_TRUE(judge(architecture::longFunctions, "core/hand/a.cpp", just).empty());
    EXPECT_EQ(judge(architecture::longFunctions, "core/hand/a.cpp", tooLong).size(), 1u);
    EXPECT_TRUE(
        judge(architecture::longFunctions, "core/hand/a.cpp", "namespace core {\n" + just + just + "}\n").empty());
    const std::string wrapped = "void f(int x,\n       int y) {\n" + body + "}\n",
                      constructor = "A::A(int x)\n    : m_x(x)\n    , m_y(x) {\n" + body + "}\n",
                      inClass = "class A {\n    A(int x)\n        : m_x(x) {\n" + body + "    }\n};\n";
    for (const std::string& text : {wrapped, constructor, inClass})
        EXPECT_EQ(judge(architecture::longFunctions, "core/hand/a.cpp", text).size(), 1u) << text;
    EXPECT_TRUE(judge(architecture::longFiles, "core/hand/a.cpp", std::string(400, '\n')).empty());
    EXPECT_EQ(judge(architecture::longFiles, "core/hand/a.cpp", std::string(401, '\n')).size(), 1u);
}

TEST(Rules, CatchFoldersThatAreCrowdedOrHaveNoPlace) {
    std::vector<SourceFile> files;
    for (int i = 0; i < 20; ++i)
        for (const char* extension : {".h", ".cpp"})
            files.push_back(parseSource("tests/support/f" + std::to_string(i) + extension, ""));
    EXPECT_TRUE(architecture::crowdedFolders(files).empty()) << "a header and its source are one";
    files.push_back(parseSource("tests/support/another.h", ""));
    EXPECT_EQ(architecture::crowdedFolders(files).size(), 1u);
    EXPECT_EQ(judge(architecture::unrankedFolders, "core/somewhere/a.h", "").size(), 1u);
    EXPECT_EQ(judge(architecture::unrankedFolders, "widgets/somewhere/a.h", "").size(), 1u);
    EXPECT_TRUE(judge(architecture::unrankedFolders, "core/hand/a.h", "").empty());
    EXPECT_TRUE(judge(architecture::unrankedFolders, "core/error.h", "").empty());
}

TEST(Rules, CatchFoldersThatADocumentDoesNotName) {
    const std::vector<SourceFile> files{parseSource("core/hand/a.h", ""), parseSource("core/demo_hand/a.h", "")};
    EXPECT_TRUE(architecture::unnamedFolders(files, "`core/hand`, `demo_hand`", {"`", "/"}).empty());
    EXPECT_EQ(architecture::unnamedFolders(files, "`core/demo_hand`", {"`", "/"}).size(), 1u);
    EXPECT_EQ(architecture::unnamedFolders(files, "`core/handle`, `core/demo_hand`", {"`", "/"}).size(), 1u);
}

TEST(Rules, CatchUnplainWords) {
    const auto caught = [](const std::string& line) {
        return judge(architecture::unplainWords, "core/hand/a.h", line + "\n").size() == 1;
    };
    EXPECT_TRUE(caught("/// The label; nothing if the joint is unknown."));
    EXPECT_TRUE(caught("throw Error(\"that is no verb\");"));
    EXPECT_TRUE(caught("/// Everybody's marks."));
    EXPECT_FALSE(caught("/// The label; empty if there is no mark."));
    EXPECT_FALSE(caught("/// Does nothing if it is open."));
    EXPECT_FALSE(caught("/// True if it is no longer open."));
}

TEST(Rules, CatchUntidyFiles) {
    const std::string licence = "// SPDX-License-Identifier: MIT\n";
    EXPECT_TRUE(judge(architecture::untidyFiles, "core/hand/a.h", licence + "#pragma once\n").empty());
    EXPECT_EQ(judge(architecture::untidyFiles, "core/hand/a.h", "#pragma once\n").size(), 1u);
    EXPECT_EQ(judge(architecture::untidyFiles, "core/hand/a.h", licence).size(), 1u);
    EXPECT_EQ(judge(architecture::untidyFiles, "core/util/a.cpp", licence).size(), 1u);
    EXPECT_EQ(judge(architecture::untidyFiles, "core/hand/helpers.cpp", licence).size(), 1u);
}

} // namespace
