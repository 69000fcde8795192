// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace core {

/// Writes a file so that it is either whole or not there: into a new file beside it, flushed to the disk, then renamed.
/// A symbolic link keeps pointing at its target; a device such as /dev/stdout is written directly.
/// Throws Error(Io) naming the file; nothing is left behind then.
void writeFileAtomically(const std::filesystem::path& file, std::string_view content);

/// A folder that comes into being all at once: filled under another name beside its final place, then renamed.
/// Without commit() it is removed again.
class PendingFolder {
public:
    /// `finalPlace` may not exist or must be an empty folder; throws Error(Io) otherwise.
    explicit PendingFolder(std::filesystem::path finalPlace);
    ~PendingFolder();
    PendingFolder(const PendingFolder&) = delete;
    PendingFolder& operator=(const PendingFolder&) = delete;

    /// Where to write until commit().
    const std::filesystem::path& path() const { return m_pending; }
    /// Moves the folder to its final place. Throws Error(Io).
    void commit();

private:
    std::filesystem::path m_final;
    std::filesystem::path m_pending;
    bool m_committed = false;
};

/// Creates a folder and its parents if they are not there. Throws Error(Io).
void ensureFolder(const std::filesystem::path& folder);

} // namespace core
