// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/hand/skeleton.h"

namespace core {

/// How closely a pose reproduces recorded bone poses.
struct RecordedPoseFit {
    Pose pose;
    std::vector<double> originErrorMm; ///< per bone, distance of the bone origins
};

/// The pose whose bones lie closest to recorded ones (worldFromBone, one per bone; mm): minimises RecordedPoseProblem
/// by Levenberg-Marquardt from a start that is read off the relative rotations in closed form. Angles are not limited:
/// recorded hands leave their limits at times. Throws Error(BadInput) if the number of bones differs.
RecordedPoseFit fitRecordedPose(const Skeleton& skeleton, const std::vector<RigidMotion>& worldFromBone);

} // namespace core
