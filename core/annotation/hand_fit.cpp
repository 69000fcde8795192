// SPDX-License-Identifier: MIT
#include "core/annotation/hand_fit.h"

namespace core {

std::optional<JointFit> fitHandToPoints(const HandModel& hand, const JointPoints& points) {
    std::vector<JointTarget> targets;
    for (const auto& [joint, point] : points) {
        const int bone = joint.hand == hand.side ? hand.skeleton.boneIndex(joint.joint) : -1;
        if (bone >= 0)
            targets.push_back({bone, point.pointInWorld, point.covariance});
    }
    return fitPoseToJoints(hand.skeleton, targets, hand.skeleton.restPose());
}

} // namespace core
