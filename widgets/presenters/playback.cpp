// SPDX-License-Identifier: MIT
#include "widgets/presenters/playback.h"

#include <algorithm>

namespace widgets {

Playback::Playback(Selection& selection, const FrameLoader& loader, QObject* parent)
    : QObject(parent)
    , m_selection(selection)
    , m_loader(loader) {
    m_timer.setTimerType(Qt::PreciseTimer);
    setFramesPerSecond(25);
    connect(&m_timer, &QTimer::timeout, this, &Playback::step);
}

void Playback::setFramesPerSecond(double framesPerSecond) {
    m_timer.setInterval(std::max(1, static_cast<int>(1000 / std::max(1.0, framesPerSecond))));
}

void Playback::play() {
    if (isPlaying() || m_selection.frameCount() < 2)
        return;
    if (m_selection.frame() + 1 >= m_selection.frameCount())
        m_selection.setFrame(0);
    m_timer.start();
    emit playingChanged(true);
}

void Playback::stop() {
    if (!isPlaying())
        return;
    m_timer.stop();
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
    if (m_selection.frame() + 1 >= m_selection.frameCount())
        stop();
    else
        m_selection.setFrame(m_selection.frame() + 1);
}

} // namespace widgets
