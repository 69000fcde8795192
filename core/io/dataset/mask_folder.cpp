// SPDX-License-Identifier: MIT
#include "core/io/dataset/mask_folder.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/error.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr int kDeepest = 2; ///< folders below the given one

bool isMaskFile(const fs::path& file) {
    static const char* const kExtensions[] = {".png", ".bmp", ".tif", ".tiff", ".jpg", ".jpeg", ".webp", ".pgm"};
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(std::begin(kExtensions), std::end(kExtensions), extension) != std::end(kExtensions) &&
           !file.filename().string().starts_with(".");
}

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Where a camera's name stands by itself in a path, from `from` on.
std::size_t findName(const std::string& path, const std::string& name, std::size_t from) {
    for (std::size_t at = path.find(name, from); at != std::string::npos; at = path.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !isWord(path[at - 1])) && (end == path.size() || !isWord(path[end])))
            return at;
    }
    return std::string::npos;
}

/// A path with the camera's name and the number taken out.
struct Named {
    std::string before, after; ///< of the number; with {camera}
    std::string digits;
};

std::optional<Named> splitNumber(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    std::size_t last = path.find_last_of("0123456789", dot);
    if (last == std::string::npos)
        return std::nullopt;
    const std::size_t before = path.find_last_not_of("0123456789", last);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    if (last - first + 1 > 9)
        return std::nullopt;
    return Named{path.substr(0, first), path.substr(last + 1), path.substr(first, last - first + 1)};
}

/// The camera's name becomes {camera} everywhere it stands, or only where it stands first if no number is left
/// otherwise ("1/1.png").
std::optional<Named> nameOf(const std::string& path, const std::string& camera) {
    std::string all = path, once = path;
    std::size_t at = findName(path, camera, 0);
    if (at == std::string::npos)
        return std::nullopt;
    once.replace(at, camera.size(), "{camera}");
    for (at = findName(all, camera, 0); at != std::string::npos; at = findName(all, camera, at + 8))
        all.replace(at, camera.size(), "{camera}");
    const std::optional<Named> named = splitNumber(all);
    return named ? named : splitNumber(once);
}

/// The longest camera name in the path: "cam_left" before "cam".
std::optional<std::pair<std::string, Named>> cameraOf(const std::string& path,
                                                      const std::vector<std::string>& cameras) {
    std::optional<std::pair<std::string, Named>> best;
    for (const std::string& camera : cameras) {
        const std::optional<Named> named = nameOf(path, camera);
        if (named && (!best || camera.size() > best->first.size()))
            best = {camera, *named};
    }
    if (!best && cameras.size() == 1) {
        if (const std::optional<Named> named = splitNumber(path))
            best = {cameras.front(), *named};
    }
    return best;
}

std::string patternOf(const fs::path& folder, const std::pair<std::string, std::string>& around,
                      const std::vector<std::string>& digits) {
    const bool isPadded = std::any_of(
        digits.begin(), digits.end(), [](const std::string& one) { return one.size() > 1 && one.front() == '0'; });
    const auto shortest = std::min_element(digits.begin(), digits.end(),
                                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
    const std::string frame = isPadded ? "{frame:0" + std::to_string(shortest->size()) + "}" : "{frame}";
    return (folder / (around.first + frame + around.second)).string();
}

} // namespace

std::map<std::string, MaskNaming> findMaskNaming(const fs::path& folder, const std::vector<std::string>& cameras) {
    std::error_code failure;
    if (!fs::is_directory(folder, failure)) {
        throw Error(ErrorCode::NotFound, folder.string(), "",
                    "no such folder of masks (a pattern needs {frame} in it)");
    }
    std::map<std::string, std::map<std::pair<std::string, std::string>, std::vector<std::string>>>
        found; // camera -> around -> digits
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failure), end;
    for (; !failure && entry != end; entry.increment(failure)) {
        if (entry.depth() >= kDeepest)
            entry.disable_recursion_pending();
        if (!isMaskFile(entry->path()))
            continue;
        if (const auto named = cameraOf(entry->path().lexically_relative(folder).generic_string(), cameras))
            found[named->first][{named->second.before, named->second.after}].push_back(named->second.digits);
    }
    std::map<std::string, MaskNaming> result;
    for (const auto& [camera, namings] : found) {
        const auto most = std::max_element(namings.begin(), namings.end(), [](const auto& a, const auto& b) {
            return a.second.size() < b.second.size();
        });
        MaskNaming naming{patternOf(folder, most->first, most->second), {}};
        for (const std::string& digits : most->second)
            naming.numbers.push_back(std::stoi(digits));
        std::sort(naming.numbers.begin(), naming.numbers.end());
        result[camera] = naming;
    }
    return result;
}

} // namespace core
