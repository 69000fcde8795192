// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace core {

/// An advisory lock on a small file, held by at most one process at a time; the system lets go of it when the process
/// ends, however it ends. The file stays, and says who held it last.
class FileLock {
public:
    enum class State {
        Held,         ///< by us
        HeldByOther,  ///< see holder()
        NotPermitted, ///< the file cannot be made or opened for writing
        NotSupported  ///< the file system has no locks
    };

    FileLock() = default;
    explicit FileLock(const std::filesystem::path& file);
    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    State state() const { return m_state; }
    /// "user@host, process 123" of the other holder; empty if it did not say.
    const std::string& holder() const { return m_holder; }

private:
    int m_descriptor = -1;
    State m_state = State::NotPermitted;
    std::string m_holder;
};

} // namespace core
