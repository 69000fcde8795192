// SPDX-License-Identifier: MIT
#include "core/io/dataset/dataset_paths.h"

#include <algorithm>

#include "core/error.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// True if `path`, with every symbolic link followed, lies in `folder` (canonical).
bool resolvesInto(const fs::path& folder, const fs::path& path) {
    std::error_code failure;
    const fs::path resolved = fs::weakly_canonical(path, failure);
    if (failure) // such as links in a circle
        return false;
    return std::mismatch(folder.begin(), folder.end(), resolved.begin(), resolved.end()).first == folder.end();
}

/// A link whose target is missing is not followed by weakly_canonical, but it is when the file is created.
bool isDanglingLink(const fs::path& path) {
    std::error_code ignored;
    return fs::is_symlink(fs::symlink_status(path, ignored)) && !fs::exists(path, ignored);
}

} // namespace

std::string leavesFolder(const fs::path& datasetFolder, const std::string& relative) {
    const fs::path path(relative);
    if (path.is_absolute())
        return "must be a path inside the dataset's folder, not an absolute one";
    if (std::find(path.begin(), path.end(), "..") != path.end())
        return "must be a path inside the dataset's folder, without \"..\"";
    std::error_code failure;
    const fs::path folder = fs::weakly_canonical(fs::absolute(datasetFolder), failure);
    fs::path part = datasetFolder;
    for (const fs::path& name : path) {
        part /= name;
        if (isDanglingLink(part) || !resolvesInto(folder, fs::absolute(part)))
            return "leads out of the dataset's folder: " + part.string() + " is a symbolic link";
    }
    return "";
}

fs::path pathInside(const fs::path& datasetFolder, const std::string& relative, const std::string& field) {
    const std::string problem = leavesFolder(datasetFolder, relative);
    if (!problem.empty()) {
        throw Error(ErrorCode::BadInput, (datasetFolder / "dataset.json").string(), field,
                    "\"" + relative + "\" " + problem);
    }
    return datasetFolder / relative;
}

fs::path annotationPathInside(const fs::path& datasetFolder, const std::string& relative, const std::string& field) {
    const fs::path file = pathInside(datasetFolder, relative, field);
    const fs::path name = fs::path(relative).filename(), parent = fs::path(relative).parent_path();
    for (const std::string& companion : {name.string() + "-wal", name.string() + "-shm", name.string() + "-journal",
                                         "." + name.string() + ".lock", name.stem().string() + ".backups"})
        pathInside(datasetFolder, (parent / companion).string(), field);
    return file;
}

fs::path cacheFile(const fs::path& datasetFolder, const std::string& name) {
    const std::string relative = ".cache/" + name;
    return leavesFolder(datasetFolder, relative).empty() ? datasetFolder / relative : fs::path();
}

std::string pathFromDataset(const fs::path& datasetFolder, const fs::path& path) {
    const fs::path normal = fs::absolute(path).lexically_normal();
    const fs::path relative = normal.lexically_relative(fs::absolute(datasetFolder).lexically_normal());
    if (!relative.empty() && *relative.begin() != "..")
        return relative.generic_string();
    // ".." climbs from where the folder really is, whatever links lead to it.
    std::error_code failure;
    const fs::path folder = fs::weakly_canonical(fs::absolute(datasetFolder), failure);
    const fs::path parent = fs::weakly_canonical(normal.parent_path(), failure);
    return (failure ? relative : (parent / normal.filename()).lexically_relative(folder)).generic_string();
}

} // namespace core
