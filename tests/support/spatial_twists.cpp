// SPDX-License-Identifier: MIT
#include "tests/support/spatial_twists.h"

namespace test {

std::vector<core::RigidMotion> spatialMotions(const core::Skeleton& skeleton, const core::Pose& pose) {
    const auto turnAbout = [](const Eigen::Vector3d& axis, const Eigen::Vector3d& point, double angle) {
        return core::exp({-angle * axis.cross(point), angle * axis});
    };
    const Eigen::Vector3d turn = pose.segment<3>(3);
    const core::RigidMotion shift{Eigen::Matrix3d::Identity(), pose.head<3>()};
    const core::RigidMotion root =
        turn.norm() > 0 ? shift * turnAbout(turn.normalized(), skeleton.centreAtRest, turn.norm()) : shift;
    std::vector<core::RigidMotion> motions;
    for (const core::Bone& bone : skeleton.bones) {
        core::RigidMotion motion = bone.parent < 0 ? root : motions[static_cast<std::size_t>(bone.parent)];
        for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
            if (static_cast<std::size_t>(skeleton.dofs[d].bone) == motions.size()) {
                const Eigen::Vector3d axis = bone.worldFromBoneAtRest.rotation * skeleton.dofs[d].axisInBone;
                motion = motion * turnAbout(axis, bone.worldFromBoneAtRest.translation,
                                            pose[core::kRigidDofs + static_cast<Eigen::Index>(d)]);
            }
        }
        motions.push_back(motion);
    }
    return motions;
}

std::vector<Eigen::Vector3d> spatiallyPosed(const core::HandModel& hand, const core::Pose& pose) {
    const std::vector<core::RigidMotion> motions = spatialMotions(hand.skeleton, pose);
    std::vector<Eigen::Vector3d> posed(hand.mesh.vertices.size(), Eigen::Vector3d::Zero());
    for (std::size_t v = 0; v < posed.size(); ++v) {
        for (int e = hand.weights.firstEntry[v]; e < hand.weights.firstEntry[v + 1]; ++e) {
            const core::SkinWeight& w = hand.weights.entries[static_cast<std::size_t>(e)];
            posed[v] += w.weight * (motions[static_cast<std::size_t>(w.bone)] * hand.mesh.vertices[v]);
        }
    }
    return posed;
}

} // namespace test
