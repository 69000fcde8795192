// SPDX-License-Identifier: MIT
#include "widgets/presenters/playback.h"

#include <algorithm>
#include <chrono>

namespace widgets {

namespace {

constexpr double kMostPerSecond = 60; ///< pictures that a screen shows

double machineMs() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

Playback::Playback(Selection& selection, FrameLoader& loader, QObject* parent)
    : QObject(parent)
    , m_selection(selection)
    , m_loader(loader)
    , m_nowMs(machineMs) {
    m_timer.setTimerType(Qt::PreciseTimer);
    setFramesPerSecond(25);
    connect(&m_timer, &QTimer::timeout, this, &Playback::step);
}

void Playback::setFramesPerSecond(double framesPerSecond) {
    m_framesPerSecond = std::max(1.0, framesPerSecond);
    m_timer.setInterval(static_cast<int>(1000 / std::min(m_framesPerSecond, kMostPerSecond)));
    if (isPlaying())
        m_pace.start(m_selection.frame(), m_framesPerSecond, m_nowMs());
}

void Playback::play() {
    if (isPlaying() || m_selection.frameCount() < 2)
        return;
    if (m_selection.frame() + 1 >= m_selection.frameCount())
        m_selection.setFrame(0);
    m_loader.setMoving(true);
    m_pace.start(m_selection.frame(), m_framesPerSecond, m_nowMs());
    m_timer.start();
    emit playingChanged(true);
}

void Playback::stop() {
    if (!isPlaying())
        return;
    m_timer.stop();
    m_loader.setMoving(false);
    emit playingChanged(false);
}

void Playback::toggle() {
    if (isPlaying())
        stop();
    else
        play();
}

void Playback::step() {
    if (!m_loader.isComplete())
        return;
    const int last = m_selection.frameCount() - 1;
    if (m_selection.frame() >= last) {
        stop();
        return;
    }
    const int next = m_pace.next(m_nowMs());
    if (next != m_selection.frame())
        m_selection.setFrame(std::min(next, last));
}

} // namespace widgets
