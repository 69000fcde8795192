// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace fuzz {

/// A file that lies in memory where the machine has a place for that: thousands of them a second cost no disk.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) {
        static int number = 0;
        std::error_code ignored;
        const std::filesystem::path memory = "/dev/shm";
        m_path = (std::filesystem::is_directory(memory, ignored) ? memory : std::filesystem::temp_directory_path()) /
                 ("handlens-fuzz-" + std::to_string(::getpid()) + "-" + std::to_string(++number));
        std::ofstream(m_path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    ~MemoryFile() {
        std::error_code ignored;
        std::filesystem::remove(m_path, ignored);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

} // namespace fuzz
