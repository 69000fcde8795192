// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace core {

/// A file or folder that may hold a calibration. What kinds look at to recognise it, and what the reader of the kind
/// then reads, is loaded once, when it is first asked for.
class CalibrationSource {
public:
    explicit CalibrationSource(std::filesystem::path path);

    const std::filesystem::path& path() const { return m_path; }
    bool isFolder() const { return m_isFolder; }
    /// True for a file with one of these extensions (lower case, with the point).
    bool hasExtension(const std::vector<std::string>& extensions) const;
    /// A YAML or XML file, or a folder that holds one.
    bool isMarkup() const;
    /// Text of the file; of a folder, its first YAML or XML file. Throws Error if it cannot be read.
    const std::string& text() const;
    bool holds(std::string_view word) const { return text().find(word) != std::string::npos; }
    /// The file as JSON. Throws Error(BadInput) if it is not JSON.
    const nlohmann::json& json() const;

private:
    std::filesystem::path m_path;
    bool m_isFolder;
    mutable std::optional<std::string> m_text;
    mutable std::shared_ptr<const nlohmann::json> m_json;
};

/// Files of a folder with one of these extensions, sorted by natural order; the path itself if it is a file.
std::vector<std::filesystem::path> calibrationFiles(const std::filesystem::path& path,
                                                    const std::vector<std::string>& extensions);

/// cam_2 before cam_10.
bool naturalLess(std::string_view a, std::string_view b);

} // namespace core
