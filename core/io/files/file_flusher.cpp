// SPDX-License-Identifier: MIT
#include "core/io/files/file_flusher.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>

namespace core {

FileFlusher::FileFlusher(std::filesystem::path file)
    : m_file(std::move(file))
    , m_thread([this](const std::stop_token& stop) { run(stop); }) {}

FileFlusher::~FileFlusher() = default;

void FileFlusher::request() {
    {
        const std::lock_guard lock(m_mutex);
        m_isRequested = true;
    }
    m_wake.notify_one();
}

void FileFlusher::run(const std::stop_token& stop) {
    constexpr std::chrono::milliseconds kGather{50}; // a drag or an import writes many times: one flush for all
    std::unique_lock lock(m_mutex);
    while (m_wake.wait(lock, stop, [this] { return m_isRequested; })) {
        m_wake.wait_for(lock, stop, kGather, [] { return false; });
        m_isRequested = false;
        lock.unlock();
        flush();
        lock.lock();
    }
}

void FileFlusher::flush() const {
    const int descriptor = ::open(m_file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fdatasync(descriptor);
        ::close(descriptor);
    }
}

} // namespace core
