// SPDX-License-Identifier: MIT
#include "core/io/files/gnuplot.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

#include "core/error.h"
#include "core/io/files/atomic_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// A program file that removes itself.
class ProgramFile {
public:
    explicit ProgramFile(const std::string& program)
        : m_path(fs::temp_directory_path() / ("handlens-figure-" + std::to_string(::getpid()) + ".gp")) {
        writeFileAtomically(m_path, program);
    }
    ~ProgramFile() {
        std::error_code ignored;
        fs::remove(m_path, ignored);
    }
    ProgramFile(const ProgramFile&) = delete;
    ProgramFile& operator=(const ProgramFile&) = delete;
    const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

struct CommandResult {
    int status = -1;
    std::string output;
};

CommandResult run(const std::string& command) {
    CommandResult result;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr)
        return result;
    std::array<char, 65536> buffer;
    for (std::size_t size = 1; size > 0;) {
        size = std::fread(buffer.data(), 1, buffer.size(), pipe);
        result.output.append(buffer.data(), size);
    }
    result.status = ::pclose(pipe);
    return result;
}

bool isInstalled() {
    return run("command -v gnuplot").status == 0;
}

/// A shell word, whatever characters it has.
std::string quotedForShell(const std::string& text) {
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::string drawn(const std::string& program) {
    const ProgramFile file(program);
    const CommandResult result = run("LC_ALL=C gnuplot " + quotedForShell(file.path().string()) + " 2>&1");
    const std::size_t begin = result.output.find("<svg");
    const std::size_t end = result.output.rfind("</svg>");
    if (result.status != 0 || begin == std::string::npos || end == std::string::npos)
        throw Error(ErrorCode::Io, "gnuplot", "", "could not draw a figure: " + result.output.substr(0, 300));
    return result.output.substr(begin, end + 6 - begin); // without XML declaration and document type
}

} // namespace

std::optional<std::vector<std::string>> drawWithGnuplot(const std::vector<std::string>& programs) {
    if (!isInstalled())
        return std::nullopt;
    std::vector<std::string> pictures;
    for (const std::string& program : programs)
        pictures.push_back(drawn(program));
    return pictures;
}

} // namespace core
