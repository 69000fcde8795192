// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>

namespace core {

/// How many states of an annotation file are kept.
inline constexpr int kKeptBackups = 10;

/// Copies the state with that number of changes into the backups of `file`, unless it is there; then drops all but the
/// newest ten. Returns the copy; empty if the file was never changed. Throws Error(Io).
std::optional<std::filesystem::path> backUp(SQLite::Database& database, const std::filesystem::path& file,
                                            std::int64_t changeCount);

/// Writes what the database holds now to a new file, flushed and then renamed to its place. Throws Error(Io).
void copyDatabase(SQLite::Database& database, const std::filesystem::path& to);

/// The backups of an annotation file, newest first.
std::vector<std::filesystem::path> backupsOf(const std::filesystem::path& annotationFile);

} // namespace core
