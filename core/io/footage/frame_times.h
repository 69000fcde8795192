// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace core {

/// Pictures that a camera lost: `count` of them after frame `after` of its file.
struct FrameGap {
    int after = 0;
    int count = 0;
    bool operator==(const FrameGap&) const = default;
};

/// What the time stamps of a video say.
struct FrameTiming {
    /// The stamps increase, most steps are equal, and at most ten million frames are lost: gaps are lost frames, and
    /// frames can be mapped to instants by time.
    bool isSane = false;
    double stepSec = 0; ///< from frame to frame where none is lost; 0 = unknown
    std::vector<FrameGap> gaps;
};

/// Looks at presentation times, in seconds, one per frame. A gap is where the frames from then on are later, by whole
/// steps, than those before: a single late or early stamp is none, nor is the rounding of stamps to milliseconds. Gaps
/// are empty unless the stamps are sane.
FrameTiming analyseTimes(const std::vector<double>& timesSec);

/// The frame rate that these steps mean: the nearest rate in use (whole numbers and 1000/1001 of them) where one is
/// within 0.1 %.
double roundedRate(double stepSec);

} // namespace core
