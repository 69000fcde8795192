// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/hand/skeleton.h"

namespace test {

/// A hand without skin: wrist at the origin, fingers along x, the back of the hand towards z, 21 joints named as in the
/// 21-joint list; the thumb towards y in a right hand, towards -y in a left one. Flexion, and abduction at the MCP and
/// CMC.
core::Skeleton fiveFingerSkeleton(core::Side side);

/// A natural pose: every flexion at `flexionRad`, fingers a little apart.
core::Pose curledPose(const core::Skeleton& skeleton, double flexionRad);

} // namespace test
