// SPDX-License-Identifier: MIT
#include "app/batch/progress.h"

#include <unistd.h>

#include <cstdio>

namespace app {

using namespace std::chrono_literals;

Progress::Progress(std::string label)
    : m_label(std::move(label))
    , m_isTerminal(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (m_isDrawn)
        std::fprintf(stderr, "\n");
}

void Progress::show(int done, int total) {
    if (total <= 0)
        return;
    m_isTerminal ? drawBar(done, total) : printLine(done, total);
}

void Progress::drawBar(int done, int total) {
    const Clock::time_point now = Clock::now();
    if (m_isDrawn && done < total && now - m_lastShown < 100ms)
        return;
    m_lastShown = now;
    m_isDrawn = true;
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(static_cast<long long>(kWidth) * done / total);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(kWidth - filled), '.');
    std::fprintf(stderr, "\r\033[K%s [%s] %d/%d%s", m_label.c_str(), bar.c_str(), done, total,
                 timeLeft(done, total).c_str());
    std::fflush(stderr);
}

void Progress::printLine(int done, int total) {
    const int tenth = static_cast<int>(10LL * done / total);
    const Clock::time_point now = Clock::now();
    if (tenth == m_lastTenth || now - m_lastShown < 1s)
        return;
    m_lastTenth = tenth;
    m_lastShown = now;
    std::fprintf(stderr, "%s: %d of %d%s\n", m_label.c_str(), done, total, timeLeft(done, total).c_str());
}

std::string Progress::timeLeft(int done, int total) const {
    const double elapsed = std::chrono::duration<double>(Clock::now() - m_start).count();
    if (done <= 0 || done >= total || elapsed < 1)
        return "";
    const int seconds = static_cast<int>(elapsed * (total - done) / done + 0.5);
    char text[32];
    std::snprintf(text, sizeof text, ", %d:%02d left", seconds / 60, seconds % 60);
    return text;
}

} // namespace app
