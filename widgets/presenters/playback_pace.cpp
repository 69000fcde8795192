// SPDX-License-Identifier: MIT
#include "widgets/presenters/playback_pace.h"

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {

constexpr double kJerkyMs = 125; ///< a picture that takes longer makes the next steps smaller
constexpr double kFluentMs = 70; ///< one that takes less may make them larger
constexpr int kMost = 16;        ///< frames at once
constexpr int kFirst = 4;        ///< frames at once, until it is known how fast they come
constexpr double kRounding = 1e-6;

} // namespace

void PlaybackPace::start(int frame, double framesPerSecond, double nowMs) {
    m_framesPerMs = std::max(0.1, framesPerSecond) / 1000;
    m_base = m_last = frame;
    m_baseMs = m_lastMs = nowMs;
    m_mostAtOnce = kFirst;
}

int PlaybackPace::next(double nowMs) {
    const int due = m_base + static_cast<int>(std::floor((nowMs - m_baseMs) * m_framesPerMs + kRounding));
    if (due <= m_last)
        return m_last;
    const double tookMs = nowMs - m_lastMs;
    const int step = due - m_last;
    if (tookMs > kJerkyMs && step > 1)
        m_mostAtOnce = std::max(1, m_mostAtOnce / 2);
    else if (tookMs < kFluentMs)
        m_mostAtOnce = std::min(kMost, m_mostAtOnce + 1);
    if (step > m_mostAtOnce) { // the clock waits
        m_base = m_last + m_mostAtOnce;
        m_baseMs = nowMs;
    }
    m_last += std::min(step, m_mostAtOnce);
    m_lastMs = nowMs;
    return m_last;
}

} // namespace widgets
