// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace core {

/// `relative` below the dataset's folder, for a file that the program may write (annotations, motion, hands, cameras,
/// caches). A stranger's dataset must not make the program write elsewhere: throws Error(BadInput) naming dataset.json
/// and `field` if the path is absolute, climbs with "..", or leads out of the folder through a symbolic link.
std::filesystem::path pathInside(const std::filesystem::path& datasetFolder, const std::string& relative,
                                 const std::string& field);

/// The same question without the error: why the path leads out of the folder, or nothing.
std::string leavesFolder(const std::filesystem::path& datasetFolder, const std::string& relative);

/// pathInside for a sequence's annotations: the files that are kept beside them (log, lock, backups) must not lead out,
/// either.
std::filesystem::path annotationPathInside(const std::filesystem::path& datasetFolder, const std::string& relative,
                                           const std::string& field);

/// A file of the dataset's cache; empty, so that nothing is kept, if the cache leads out of the folder.
std::filesystem::path cacheFile(const std::filesystem::path& datasetFolder, const std::string& name);

/// How dataset.json names a file or pattern, which may lie outside: relative to the dataset's folder, which need not
/// exist yet.
std::string pathFromDataset(const std::filesystem::path& datasetFolder, const std::filesystem::path& path);

} // namespace core
