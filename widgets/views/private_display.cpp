// SPDX-License-Identifier: MIT
#include "widgets/views/private_display.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"

namespace widgets {

namespace {

constexpr int kStartTimeoutMs = 20000;

/// In the child: becomes Xvfb, which writes its display number to `displayFd`. Does not return.
[[noreturn]] void becomeServer(int displayFd, pid_t parent, const std::string& screen) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(126); // the parent ended before the line above
    setpgid(0, 0);  // Ctrl+C in the terminal is for the program, not for its server
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    const std::string fd = std::to_string(displayFd);
    execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp", "-noreset",
           "+extension", "GLX", "-dpi", "96", static_cast<char*>(nullptr));
    _exit(127);
}

/// Reads the display number that the server writes once it listens; empty if it ended or took too long.
std::string readDisplayNumber(int fd) {
    std::string text;
    while (text.find('\n') == std::string::npos) {
        pollfd waiting{fd, POLLIN, 0};
        const int ready = poll(&waiting, 1, kStartTimeoutMs);
        if (ready < 0 && errno == EINTR)
            continue;
        char buffer[16];
        const ssize_t count = ready > 0 ? read(fd, buffer, sizeof buffer) : 0;
        if (count <= 0)
            return {};
        text.append(buffer, static_cast<std::size_t>(count));
    }
    return text.substr(0, text.find('\n'));
}

} // namespace

PrivateDisplay::PrivateDisplay(int widthPx, int heightPx) {
    const std::string screen = std::to_string(widthPx) + "x" + std::to_string(heightPx) + "x24";
    int ends[2];
    if (pipe(ends) != 0)
        throw core::Error(core::ErrorCode::Io, "Xvfb", "", std::string("cannot make a pipe: ") + std::strerror(errno));
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    const pid_t parent = getpid();
    m_process = fork();
    if (m_process == 0)
        becomeServer(ends[1], parent, screen);
    close(ends[1]);
    const std::string number = m_process > 0 ? readDisplayNumber(ends[0]) : std::string();
    close(ends[0]);
    if (number.empty()) {
        int status = 0;
        if (m_process > 0) {
            kill(m_process, SIGKILL);
            waitpid(m_process, &status, 0);
        }
        const bool missing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
        throw core::Error(missing ? core::ErrorCode::NotFound : core::ErrorCode::Io, "Xvfb", "",
                          missing ? "the program is not there: install the package xvfb" : "it did not start");
    }
    m_name = ":" + number;
    setenv("DISPLAY", m_name.c_str(), 1);
    setenv("QT_QPA_PLATFORM", "xcb", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    unsetenv("WAYLAND_DISPLAY");
}

PrivateDisplay::~PrivateDisplay() {
    kill(m_process, SIGTERM);
    waitpid(m_process, nullptr, 0);
}

} // namespace widgets
