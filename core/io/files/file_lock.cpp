// SPDX-License-Identifier: MIT
#include "core/io/files/file_lock.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <utility>

namespace core {

namespace {

std::string ownName() {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    std::array<char, 4096> buffer{};
    passwd entry{};
    passwd* found = nullptr;
    ::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found);
    const std::string user = found ? found->pw_name : std::to_string(::geteuid());
    return user + "@" + host.data() + ", process " + std::to_string(::getpid());
}

std::string readHolder(int descriptor) {
    std::array<char, 400> text{};
    const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
    const std::string_view line(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
    return std::string(line.substr(0, line.find('\n')));
}

void writeHolder(int descriptor) {
    const std::string line = ownName() + "\n";
    // Who holds the lock is a courtesy: the lock holds without it.
    if (::ftruncate(descriptor, 0) != 0 || ::pwrite(descriptor, line.data(), line.size(), 0) < 0)
        return;
}

} // namespace

FileLock::FileLock(const std::filesystem::path& file)
    : m_descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (m_descriptor < 0)
        return;
    if (::flock(m_descriptor, LOCK_EX | LOCK_NB) == 0) {
        m_state = State::Held;
        writeHolder(m_descriptor);
    } else if (errno == EWOULDBLOCK) {
        m_state = State::HeldByOther;
        m_holder = readHolder(m_descriptor);
    } else {
        m_state = State::NotSupported;
    }
}

FileLock::~FileLock() {
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

FileLock::FileLock(FileLock&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1))
    , m_state(other.m_state)
    , m_holder(std::move(other.m_holder)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(m_descriptor, other.m_descriptor);
    std::swap(m_state, other.m_state);
    std::swap(m_holder, other.m_holder);
    return *this;
}

} // namespace core
