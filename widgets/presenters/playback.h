// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "widgets/document/selection.h"
#include "widgets/jobs/frame_loader.h"

namespace widgets {

/// Plays the sequence: a frame is followed by the next one when its time is over and all its pictures were shown.
/// Ends at the last frame.
class Playback : public QObject {
    Q_OBJECT

public:
    Playback(Selection& selection, const FrameLoader& loader, QObject* parent = nullptr);

    void setFramesPerSecond(double framesPerSecond);
    void play();
    void stop();
    void toggle();
    bool isPlaying() const { return m_timer.isActive(); }

signals:
    void playingChanged(bool playing);

private:
    void step();

    Selection& m_selection;
    const FrameLoader& m_loader;
    QTimer m_timer;
};

} // namespace widgets
