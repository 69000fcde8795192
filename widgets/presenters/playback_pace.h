// SPDX-License-Identifier: MIT
#pragma once

namespace widgets {

/// Which frame a playback shows when. It keeps the recording's time while pictures come fast enough, leaving out frames
/// in between; where they do not, it plays slower instead of leaving out ever more.
class PlaybackPace {
public:
    /// `frame` is shown at `nowMs`; the next is due 1000 / framesPerSecond later.
    void start(int frame, double framesPerSecond, double nowMs);
    /// Called when the last frame has been shown: the frame that is due now, which is the last one if none is.
    int next(double nowMs);

private:
    double m_framesPerMs = 0.025;
    int m_base = 0; ///< frame that was due at m_baseMs
    double m_baseMs = 0;
    int m_last = 0;      ///< shown
    double m_lastMs = 0; ///< when it was asked for
    int m_mostAtOnce = 1;
};

} // namespace widgets
