// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

namespace core {

/// Sends what was written to a file on to the disk a moment after it was asked to, on a thread of its own: a writer
/// need not wait for the disk, and yet a power failure costs no more than the last moment.
class FileFlusher {
public:
    explicit FileFlusher(std::filesystem::path file);
    ~FileFlusher(); ///< flushes once more if asked to
    FileFlusher(const FileFlusher&) = delete;
    FileFlusher& operator=(const FileFlusher&) = delete;

    /// The file has changed. Returns at once.
    void request();

private:
    void run(const std::stop_token& stop);
    void flush() const;

    std::filesystem::path m_file;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    bool m_isRequested = false;
    std::jthread m_thread; ///< last: it uses the others
};

} // namespace core
