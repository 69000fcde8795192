// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_database.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <limits>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/file_flusher.h"
#include "core/io/files/file_lock.h"
#include "core/io/store/annotation_backups.h"
#include "core/io/store/annotation_schema.h"
#include "core/io/store/annotation_tables.h"

namespace core {

namespace fs = std::filesystem;

namespace {

std::string adviceFor(const fs::path& file) {
    const auto backups = backupsOf(file);
    return backups.empty() ? "; there is no backup" : "; the newest backup is " + backups.front().string();
}

std::uint32_t bigEndian(const unsigned char* bytes) {
    return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 | std::uint32_t(bytes[2]) << 8 | bytes[3];
}

} // namespace

Error damagedFile(const fs::path& file, const std::string& detail) {
    return {ErrorCode::BadInput, file.string(), "", detail + adviceFor(file)};
}

/// What SQLite says, as one of our errors.
Error translatedError(const SQLite::Exception& problem, const fs::path& file) {
    switch (problem.getErrorCode()) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR: // a table or column is missing
    case SQLITE_MISMATCH:
    case SQLITE_CONSTRAINT:
        return damagedFile(file, std::string("is damaged (") + problem.what() + ")");
    case SQLITE_FULL:
        return {ErrorCode::Io, file.string(), "", "cannot be written: the disk is full"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
        return {ErrorCode::Io, file.string(), "", "cannot be written: file or folder is read-only"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return {ErrorCode::Io, file.string(), "", "is in use by another program"};
    default:
        return {ErrorCode::Io, file.string(), "", std::string("cannot be read or written: ") + problem.what()};
    }
}

fs::path sideFile(const fs::path& file, const char* suffix) {
    return file.string() + suffix;
}

void checkVersion(const fs::path& file, long long applicationId, long long version) {
    if (applicationId != kAnnotationApplicationId)
        throw Error(ErrorCode::BadInput, file.string(), "", "is an SQLite file, but not one with annotations");
    if (version > kAnnotationVersion) {
        throw Error(ErrorCode::Newer, file.string(), "version",
                    std::to_string(version) + " was written by a newer Handlens; this one reads up to " +
                        std::to_string(kAnnotationVersion));
    }
    if (version < 1)
        throw damagedFile(file, "has no valid version");
}

/// Looks at the first bytes without SQLite, which might write.
void checkDatabaseHeader(const fs::path& file) {
    std::array<char, 100> header{};
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw Error(ErrorCode::Io, file.string(), "", "cannot be read");
    stream.read(header.data(), header.size());
    if (stream.gcount() == 0)
        throw damagedFile(file, "is empty: it has lost its content");
    constexpr std::string_view kMagic("SQLite format 3\0", 16);
    if (stream.gcount() < 100 || std::string_view(header.data(), 16) != kMagic)
        throw damagedFile(file, "is not an annotation file, or is cut off");
    const auto* bytes = reinterpret_cast<const unsigned char*>(header.data());
    checkVersion(file, bigEndian(bytes + 68), bigEndian(bytes + 60));
}

/// SQLite's own check of every page and of the constraints; then the version once more, which may still be in the log.
void checkDatabaseContent(SQLite::Database& database, const fs::path& file) {
    SQLite::Statement check(database, "PRAGMA integrity_check(1)");
    const std::string verdict = check.executeStep() ? check.getColumn(0).getString() : "no answer";
    if (verdict != "ok")
        throw damagedFile(file, "is damaged (" + verdict + ")");
    checkVersion(file, database.execAndGet("PRAGMA application_id").getInt64(),
                 database.execAndGet("PRAGMA user_version").getInt64());
    constexpr int kTables = 7;
    const int tables =
        database
            .execAndGet(
                "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN ('mark', 'note', 'journal', "
                "'mark_change', 'note_change', 'setting', 'counter')")
            .getInt();
    if (tables != kTables)
        throw damagedFile(file, "lacks a table");
    for (const auto& [table, condition] : annotationRowConditions()) {
        SQLite::Statement odd(database, "SELECT 1 FROM " + table + " WHERE (" + condition + ") IS NOT TRUE LIMIT 1");
        if (odd.executeStep())
            throw damagedFile(file, "is damaged (a row of table " + table + " makes no sense)");
    }
}

/// A new file with empty tables, there all at once.
void createDatabaseFile(const fs::path& file) {
    if (fs::exists(sideFile(file, "-wal"))) {
        throw Error(ErrorCode::BadInput, file.string(), "",
                    "is gone, but its log " + sideFile(file, "-wal").string() +
                        " is there: bring the file back, or move the log away" + adviceFor(file));
    }
    const fs::path pending = sideFile(file, (".part-" + std::to_string(::getpid())).c_str());
    std::error_code ignored;
    try {
        {
            SQLite::Database database(pending.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
            database.exec("PRAGMA journal_mode = WAL");
            createAnnotationTables(database);
        }
        fs::rename(pending, file);
    } catch (const fs::filesystem_error& problem) {
        fs::remove(pending, ignored);
        throw Error(ErrorCode::Io, file.string(), "", "cannot be written: " + problem.code().message());
    } catch (...) {
        for (const char* suffix : {"", "-wal", "-shm"})
            fs::remove(sideFile(pending, suffix), ignored);
        throw;
    }
}

bool isWritablePath(const fs::path& path) {
    return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

} // namespace core
