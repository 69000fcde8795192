// SPDX-License-Identifier: MIT
#include "core/io/footage/image_folder.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/error.h"
#include "core/io/files/file_pattern.h"

namespace core {

namespace fs = std::filesystem;

namespace {

bool isImage(const fs::path& file) {
    static const char* const kExtensions[] = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp"};
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return file.filename().string().front() != '.' &&
           std::find(std::begin(kExtensions), std::end(kExtensions), extension) != std::end(kExtensions);
}

/// A file name around its last number.
struct NumberedName {
    std::string before, digits, after;
};

NumberedName splitName(const std::string& name) {
    const std::size_t stem = name.rfind('.');
    const std::size_t last = name.find_last_of("0123456789", stem);
    if (last == std::string::npos)
        return {name, "", ""};
    const std::size_t before = name.find_last_not_of("0123456789", last);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    return {name.substr(0, first), name.substr(first, last - first + 1), name.substr(last + 1)};
}

Error notNumbered(const fs::path& file) {
    return Error(ErrorCode::BadInput, file.string(), "", "is not numbered like the other images of its folder");
}

} // namespace

ImagePattern findImagePattern(const fs::path& folder) {
    std::map<int, std::string> names; // the digits, by number
    std::optional<NumberedName> common;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (!isImage(entry.path()))
            continue;
        const NumberedName name = splitName(entry.path().filename().string());
        if (name.digits.empty() || name.digits.size() > 9 ||
            (common && (common->before != name.before || common->after != name.after)) ||
            !names.emplace(std::stoi(name.digits), name.digits).second)
            throw notNumbered(entry.path());
        common = common.value_or(name);
    }
    if (!common)
        throw Error(ErrorCode::BadInput, folder.string(), "", "holds no images");
    const auto isPadded = [](const auto& entry) { return entry.second.size() > 1 && entry.second.front() == '0'; };
    const auto padded = std::find_if(names.begin(), names.end(), isPadded);
    const std::string frame =
        padded != names.end() ? "{frame:0" + std::to_string(padded->second.size()) + "}" : "{frame}";
    ImagePattern result{(folder / (common->before + frame + common->after)).string(), {}};
    for (const auto& [number, digits] : names) {
        if (fillPattern(frame, "", number) != digits) // 007 beside 08
            throw notNumbered(folder / (common->before + digits + common->after));
        result.numbers.push_back(number);
    }
    return result;
}

std::vector<int> imageNumbers(const std::string& pattern, const std::string& camera) {
    std::string filled = pattern;
    for (std::size_t at = filled.find("{camera}"); at != std::string::npos;
         at = filled.find("{camera}", at + camera.size()))
        filled.replace(at, 8, camera);
    // The folder whose entries differ in the number: the number may stand in a folder's name.
    const std::size_t frame = std::min(filled.find("{frame"), filled.size());
    const std::size_t slash = filled.rfind('/', frame);
    const std::size_t end = std::min(filled.find('/', frame), filled.size());
    const fs::path folder = slash == std::string::npos ? "." : filled.substr(0, slash + 1);
    const std::string name =
        slash == std::string::npos ? filled.substr(0, end) : filled.substr(slash + 1, end - slash - 1);
    std::vector<int> numbers;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::optional<int> number = numberIn(name, entry.path().filename().string());
        if (number && *number >= 0 && fs::is_regular_file(fillPattern(filled, camera, *number), ignored))
            numbers.push_back(*number);
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

} // namespace core
