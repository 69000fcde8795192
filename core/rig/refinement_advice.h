// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/rig/rig_clicks.h"
#include "core/rig/rig_health.h"

namespace core {

/// Whether refining a calibration is worth it, and what it still needs.
enum class RefinementAdvice {
    NeedsMoreJoints, ///< not possible yet
    NotNeeded,       ///< the calibration fits the clicks
    NeedsMoreFrames, ///< possible, but the clicks' own noise would still move the cameras
    Worthwhile
};

struct RefinementNeeds {
    RefinementAdvice advice = RefinementAdvice::NeedsMoreJoints;
    int wellSeenJoints = 0;    ///< seen by three cameras or more
    int leastJoints = 0;       ///< of these that a refinement needs
    int worthwhileJoints = 60; ///< from so many and so many frames on, the clicks' noise hardly moves a camera
    int worthwhileFrames = 3;
};

RefinementNeeds adviseRefinement(const RigHealth& health, const std::vector<RigJoint>& joints);

} // namespace core
