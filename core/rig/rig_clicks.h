// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/geometry/triangulation.h"

namespace core {

/// The manual clicks of one joint in one frame by one rater, as a calibration is judged and refined from them.
struct RigJoint {
    int sequence = 0; ///< index of the sequence
    int frame = 0;
    std::string rater;
    JointId joint;
    std::vector<Observation> clicks; ///< two or more, each of another camera, in the order of the marks
};

/// Adds every joint of `set` that two or more cameras have clicked (marks outside their picture do not count); of
/// one rater, or of all if `rater` is empty.
void addRigJoints(std::vector<RigJoint>& joints, const AnnotationSet& set, const std::vector<Camera>& cameras,
                  int sequence, const std::string& rater = {});

/// The number of different frames (of any sequence) among the joints.
int countFrames(const std::vector<RigJoint>& joints);

} // namespace core
