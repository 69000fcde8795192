// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace architecture {

/// A file as it stands; empty if there is none.
std::string readText(const std::filesystem::path& file);

/// One `#include`: what stands between the quotes or angle brackets.
struct Include {
    std::string path;
    bool isQuoted = false;
    int line = 0; ///< from 1
};

/// A source file under its path from the project's root, with '/' between folders.
struct SourceFile {
    std::string path;
    std::vector<std::string> lines;
    std::vector<Include> includes;

    bool isHeader() const { return path.ends_with(".h"); }
    /// The first `depth` folders, such as core/geometry; the whole folder if there are fewer.
    std::string folder(int depth) const;
};

SourceFile parseSource(std::string path, const std::string& text);

/// All .h and .cpp files of core, widgets, app and tests, sorted by path.
std::vector<SourceFile> readSourceTree(const std::filesystem::path& root);

} // namespace architecture
