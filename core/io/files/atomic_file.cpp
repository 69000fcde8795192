// SPDX-License-Identifier: MIT
#include "core/io/files/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include "core/error.h"

namespace core {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void throwIo(const fs::path& file, int code) {
    throw Error(ErrorCode::Io, file.string(), "", "cannot be written: " + std::generic_category().message(code));
}

/// A name beside `place` that no other writer of this machine uses.
fs::path besides(const fs::path& place) {
    static std::atomic<int> counter{0};
    fs::path name = place.filename();
    name += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    return place.parent_path() / name;
}

/// A file descriptor that closes itself.
struct Descriptor {
    int value;
    ~Descriptor() {
        if (value >= 0)
            ::close(value);
    }
};

/// 0, or the errno of what failed.
int writeAll(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno != EINTR)
            return errno;
        content.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return 0;
}

/// Makes the rename itself last; file systems that cannot do so are left alone.
void syncFolder(const fs::path& folder) {
    const Descriptor descriptor{::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (descriptor.value >= 0)
        ::fsync(descriptor.value);
}

void writeDirectly(const fs::path& file, std::string_view content) {
    const Descriptor descriptor{::open(file.c_str(), O_WRONLY | O_CLOEXEC)};
    const int failure = descriptor.value < 0 ? errno : writeAll(descriptor.value, content);
    if (failure != 0)
        throwIo(file, failure);
}

/// Writes and flushes a new file; 0 or the errno of what failed.
int writeNewFile(const fs::path& file, std::string_view content) {
    const Descriptor descriptor{::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666)};
    if (descriptor.value < 0)
        return errno;
    const int failure = writeAll(descriptor.value, content);
    if (failure != 0)
        return failure;
    return ::fsync(descriptor.value) == 0 || errno == EINVAL ? 0 : errno;
}

} // namespace

void writeFileAtomically(const fs::path& file, std::string_view content) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    if (fs::is_directory(status))
        throwIo(file, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        writeDirectly(file, content);
        return;
    }
    const fs::path target =
        fs::is_symlink(fs::symlink_status(file, ignored)) ? fs::weakly_canonical(file, ignored) : file;
    const fs::path pending = besides(target);
    int failure = writeNewFile(pending, content);
    if (failure == 0 && ::rename(pending.c_str(), target.c_str()) != 0)
        failure = errno;
    if (failure != 0) {
        ::unlink(pending.c_str());
        throwIo(file, failure);
    }
    syncFolder(target.parent_path());
}

void ensureFolder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure || !fs::is_directory(folder))
        throwIo(folder, failure ? failure.value() : ENOTDIR);
}

PendingFolder::PendingFolder(fs::path finalPlace)
    : m_final(std::move(finalPlace)) {
    if (!m_final.has_filename())
        m_final = m_final.parent_path(); // "name/" and "name" are the same folder
    std::error_code ignored;
    const bool isFree =
        !fs::exists(m_final, ignored) || (fs::is_directory(m_final, ignored) && fs::is_empty(m_final, ignored));
    if (!isFree)
        throw Error(ErrorCode::Io, m_final.string(), "", "is there already and is not empty");
    m_pending = besides(m_final);
    ensureFolder(m_pending);
}

PendingFolder::~PendingFolder() {
    if (!m_committed) {
        std::error_code ignored;
        fs::remove_all(m_pending, ignored);
    }
}

void PendingFolder::commit() {
    if (::rename(m_pending.c_str(), m_final.c_str()) != 0)
        throwIo(m_final, errno);
    m_committed = true;
    syncFolder(m_final.parent_path());
}

} // namespace core
