// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace core {

/// How the masks of one camera are named in a folder.
struct MaskNaming {
    std::string pattern;      ///< with {frame} or {frame:06}, and with {camera} where the camera's name stands
    std::vector<int> numbers; ///< that exist, ascending
};

/// Finds the masks of these cameras in a folder or its folders: files with the camera's name and a number in their
/// path, such as <camera>/<number>.png or <camera>_<number>.png. With one camera its name need not be in the path. By
/// camera; those without are left out. Throws Error(NotFound) if `folder` is not a folder.
std::map<std::string, MaskNaming> findMaskNaming(const std::filesystem::path& folder,
                                                 const std::vector<std::string>& cameras);

} // namespace core
