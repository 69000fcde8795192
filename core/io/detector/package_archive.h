// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace core {

/// The files of a package of npm, by their names within it ("hands.js"), read into memory: those whose names
/// `isWanted`. `package` is a folder, or a .tgz whose entries lie in one folder. Throws Error: NotFound if there is
/// none, BadInput if the archive is damaged or larger than 200 MB unpacked.
std::map<std::string, std::string> readPackage(const std::filesystem::path& package,
                                               bool (*isWanted)(const std::string& name));

} // namespace core
