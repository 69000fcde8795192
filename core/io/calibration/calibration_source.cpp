// SPDX-License-Identifier: MIT
#include "core/io/calibration/calibration_source.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

#include "core/io/files/json_file.h"
#include "core/io/files/text_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kMarkup{".yml", ".yaml", ".xml"};

std::string lowerExtension(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool isOneOf(const std::string& extension, const std::vector<std::string>& extensions) {
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

} // namespace

CalibrationSource::CalibrationSource(fs::path path)
    : m_path(std::move(path))
    , m_isFolder(fs::is_directory(m_path)) {}

bool CalibrationSource::hasExtension(const std::vector<std::string>& extensions) const {
    return !m_isFolder && isOneOf(lowerExtension(m_path), extensions);
}

bool CalibrationSource::isMarkup() const {
    return m_isFolder ? !calibrationFiles(m_path, kMarkup).empty() : hasExtension(kMarkup);
}

const std::string& CalibrationSource::text() const {
    if (!m_text) {
        const std::vector<fs::path> files = calibrationFiles(m_path, kMarkup);
        m_text = files.empty() ? std::string() : readTextFile(files.front());
    }
    return *m_text;
}

const nlohmann::json& CalibrationSource::json() const {
    if (!m_json)
        m_json = std::make_shared<const nlohmann::json>(parseJson(text(), m_path.string()));
    return *m_json;
}

std::vector<fs::path> calibrationFiles(const fs::path& path, const std::vector<std::string>& extensions) {
    if (!fs::is_directory(path))
        return {path};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
        if (entry.is_regular_file() && isOneOf(lowerExtension(entry.path()), extensions))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return naturalLess(a.filename().string(), b.filename().string());
    });
    return files;
}

bool naturalLess(std::string_view a, std::string_view b) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (isDigit(a[i]) && isDigit(b[j])) {
            const std::size_t endA = std::min(a.find_first_not_of("0123456789", i), a.size());
            const std::size_t endB = std::min(b.find_first_not_of("0123456789", j), b.size());
            std::string_view numberA = a.substr(i, endA - i), numberB = b.substr(j, endB - j);
            numberA.remove_prefix(std::min(numberA.find_first_not_of('0'), numberA.size()));
            numberB.remove_prefix(std::min(numberB.find_first_not_of('0'), numberB.size()));
            if (numberA != numberB)
                return numberA.size() != numberB.size() ? numberA.size() < numberB.size() : numberA < numberB;
            i = endA;
            j = endB;
        } else if (a[i] != b[j]) {
            return a[i] < b[j];
        } else {
            ++i;
            ++j;
        }
    }
    return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

} // namespace core
