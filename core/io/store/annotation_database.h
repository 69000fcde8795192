// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <string>

#include "core/error.h"

namespace core {

/// An error that says what is wrong with the file and which backup is the newest.
Error damagedFile(const std::filesystem::path& file, const std::string& detail);
/// What SQLite says, as one of our errors.
Error translatedError(const SQLite::Exception& problem, const std::filesystem::path& file);
/// The file's companion with that suffix: -wal, -shm.
std::filesystem::path sideFile(const std::filesystem::path& file, const char* suffix);
/// Reads the file's first bytes: throws Error unless they are those of an annotation file of a version that is known.
void checkDatabaseHeader(const std::filesystem::path& file);
/// Throws Error unless the whole database is sound.
void checkDatabaseContent(SQLite::Database& database, const std::filesystem::path& file);
/// A new file with empty tables, there all at once.
void createDatabaseFile(const std::filesystem::path& file);
bool isWritablePath(const std::filesystem::path& path);

/// A folder for copies that goes with the store.
class TemporaryCopy {
public:
    TemporaryCopy() = default;
    /// Copies the file and its log.
    explicit TemporaryCopy(const std::filesystem::path& file) {
        std::string name = (std::filesystem::temp_directory_path() / "handlens-XXXXXX").string();
        if (!::mkdtemp(name.data()))
            throw Error(ErrorCode::Io, name, "", "cannot be created");
        m_folder = name;
        m_file = m_folder / file.filename();
        std::filesystem::copy_file(file, m_file);
        std::filesystem::copy_file(sideFile(file, "-wal"), sideFile(m_file, "-wal"));
    }
    TemporaryCopy(TemporaryCopy&& other) noexcept {
        std::swap(m_folder, other.m_folder);
        std::swap(m_file, other.m_file);
    }
    TemporaryCopy& operator=(TemporaryCopy&& other) noexcept {
        std::swap(m_folder, other.m_folder);
        std::swap(m_file, other.m_file);
        return *this;
    }
    ~TemporaryCopy() {
        std::error_code ignored;
        if (!m_folder.empty())
            std::filesystem::remove_all(m_folder, ignored);
    }
    const std::filesystem::path& file() const { return m_file; }

private:
    std::filesystem::path m_folder, m_file;
};

} // namespace core
