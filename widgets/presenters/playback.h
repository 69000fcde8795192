// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QObject>
#include <QTimer>

#include "widgets/document/selection.h"
#include "widgets/jobs/frame_loader.h"
#include "widgets/presenters/playback_pace.h"

namespace widgets {

/// Plays the sequence in the recording's time: once all views show a frame, the one that is due follows. Frames whose
/// time is over are left out; where pictures come slower than that, it plays slower (PlaybackPace). Ends at the last
/// frame.
class Playback : public QObject {
    Q_OBJECT

public:
    Playback(Selection& selection, FrameLoader& loader, QObject* parent = nullptr);

    void setFramesPerSecond(double framesPerSecond);
    void play();
    void stop();
    void toggle();
    bool isPlaying() const { return m_timer.isActive(); }
    /// Another clock than the machine's, in milliseconds.
    void setClock(std::function<double()> nowMs) { m_nowMs = std::move(nowMs); }

signals:
    void playingChanged(bool playing);

private:
    void step();

    Selection& m_selection;
    FrameLoader& m_loader;
    QTimer m_timer;
    double m_framesPerSecond = 25;
    PlaybackPace m_pace;
    std::function<double()> m_nowMs;
};

} // namespace widgets
