// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace app {

/// Shows on standard error how far long work is: a bar that redraws itself on a terminal, else a plain line at every
/// tenth of the work and at most once a second. Standard output holds results only.
class Progress {
public:
    explicit Progress(std::string label);
    ~Progress(); ///< ends the bar's line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(int done, int total);

private:
    using Clock = std::chrono::steady_clock;

    void drawBar(int done, int total);
    void printLine(int done, int total);
    std::string timeLeft(int done, int total) const;

    std::string m_label;
    bool m_isTerminal;
    bool m_isDrawn = false;
    int m_lastTenth = 0;
    Clock::time_point m_start = Clock::now();
    Clock::time_point m_lastShown = m_start;
};

} // namespace app
