// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "core/detection/hand_views.h"
#include "core/hand/skeleton.h"

namespace core {

/// A hand of a frame that a side was given to.
struct SidedHand {
    SpatialHand hand;
    Side side = Side::Left;
    double sideDoubt = 0; ///< 0 = sure .. 1 = could as well be the other one
};

/// Says which hands of all frames are left and which are right: hands that are surely the same in neighbouring frames
/// decide together, by the sum of what all views of all these frames say; two hands of a frame are never of the same
/// side. `frames`: number and at most two hands.
std::map<int, std::vector<SidedHand>> giveSides(const std::map<int, std::vector<SpatialHand>>& frames);

} // namespace core
