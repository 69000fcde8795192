// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/hand/hand_model.h"

namespace core {

/// Of `frames` (ascending) those that the detector looks at first: at least `every` frames apart; the first and the
/// last one are among them.
std::vector<int> keyFrames(const std::vector<int>& frames, int every);

/// At most `most` of the values, evenly drawn.
std::vector<int> evenlyDrawn(const std::vector<int>& values, std::size_t most);

/// Where hands go on to from `last`, a frame after `before` (either way in time; empty: not known): as far again.
/// `share`: of the step, 1 as it was. Poses that are empty in one of them stay those of `last`.
HandPoses predictedPoses(const HandPoses& last, const HandPoses& before, double share);

/// The frame after `frame` (direction 1) or before it (-1) among `frames` (ascending); none if it is more than
/// `mostGapFrames` away.
std::optional<int> nextFrame(const std::vector<int>& frames, int frame, int direction, int mostGapFrames);

/// A step of tracking.
struct TrackStep {
    int from = 0, to = 0;
    int direction = 1; ///< +1: to later frames
    double doubt = 0;  ///< of where it comes from
};

/// Which frame is fitted next from which neighbour: always the step that comes from the surest frame.
class TrackQueue {
public:
    /// `frames` ascending; steps over more than `mostGapFrames` are not taken.
    TrackQueue(std::vector<int> frames, int mostGapFrames)
        : m_frames(std::move(frames))
        , m_mostGapFrames(mostGapFrames) {}

    /// A frame has been fitted: its neighbours may follow from it, all of them or those in one direction (0: both).
    void add(int frame, double doubt, int direction = 0);
    std::optional<TrackStep> next();

private:
    std::vector<int> m_frames;
    int m_mostGapFrames;
    std::vector<TrackStep> m_steps;
};

} // namespace core
