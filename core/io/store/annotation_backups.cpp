// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_backups.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <system_error>

#include "core/error.h"
#include "core/io/files/atomic_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

fs::path folderOf(const fs::path& file) {
    return file.parent_path() / (file.stem().string() + ".backups");
}

/// The number of changes, in ten digits so that names sort.
std::string backupName(const fs::path& file, std::int64_t changeCount) {
    std::ostringstream name;
    name << file.stem().string() << '.' << std::setw(10) << std::setfill('0') << changeCount
         << file.extension().string();
    return name.str();
}

/// Waits until the file is on the disk; SQLite does not for such copies.
void flush(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

void dropOldest(const fs::path& file) {
    const std::vector<fs::path> backups = backupsOf(file);
    for (std::size_t i = kKeptBackups; i < backups.size(); ++i) {
        std::error_code ignored;
        fs::remove(backups[i], ignored);
    }
}

} // namespace

std::optional<fs::path> backUp(SQLite::Database& database, const fs::path& file, std::int64_t changeCount) {
    if (changeCount == 0)
        return std::nullopt;
    const fs::path backup = folderOf(file) / backupName(file, changeCount);
    std::error_code failure;
    if (fs::exists(backup, failure))
        return backup;
    ensureFolder(backup.parent_path());
    copyDatabase(database, backup);
    dropOldest(file);
    return backup;
}

void copyDatabase(SQLite::Database& database, const fs::path& to) {
    const fs::path pending = to.string() + ".part-" + std::to_string(::getpid());
    std::error_code failure;
    try {
        fs::remove(pending, failure);
        SQLite::Statement copy(database, "VACUUM INTO ?");
        copy.bind(1, pending.string());
        copy.exec();
        flush(pending);
        fs::rename(pending, to);
    } catch (const std::exception& problem) {
        fs::remove(pending, failure);
        throw Error(ErrorCode::Io, to.string(), "", std::string("the copy cannot be written: ") + problem.what());
    }
}

std::vector<fs::path> backupsOf(const fs::path& annotationFile) {
    std::vector<fs::path> backups;
    std::error_code failure;
    for (fs::directory_iterator entry(folderOf(annotationFile), failure), end; !failure && entry != end;
         entry.increment(failure))
        if (entry->path().extension() == annotationFile.extension())
            backups.push_back(entry->path());
    std::sort(backups.rbegin(), backups.rend());
    return backups;
}

} // namespace core
