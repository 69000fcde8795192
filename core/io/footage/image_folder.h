// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace core {

/// Numbered images.
struct ImagePattern {
    std::string pattern;      ///< with {frame} or {frame:06}
    std::vector<int> numbers; ///< of the images that exist, increasing; there may be gaps
};

/// A folder of images whose names differ in one running number, as a pattern: "shots" -> "shots/img_{frame:04}.png".
/// Files whose name begins with a dot (macOS leaves such beside every image) are passed over; upper and lower case of
/// the extension do not matter. Throws Error(BadInput) if there are no images or their names are not numbered in one
/// way.
ImagePattern findImagePattern(const std::filesystem::path& folder);

/// The numbers for which the pattern, with {camera} filled in, names a file, increasing.
std::vector<int> imageNumbers(const std::string& pattern, const std::string& camera);

} // namespace core
