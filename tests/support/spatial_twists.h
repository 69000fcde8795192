// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/rigid_motion.h"
#include "core/hand/hand_model.h"

namespace test {

/// The motion of every bone from the rest pose by the product of exponentials (Murray, Li, Sastry 1994): all twists are
/// those of the rest pose. An oracle that shares no kinematics with the skeleton's own walk along the tree.
inline std::vector<core::RigidMotion> spatialMotions(const core::Skeleton& skeleton, const core::Pose& pose) {
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

/// v(theta) = sum_j a_vj T_j(theta) v.
inline std::vector<Eigen::Vector3d> spatiallyPosed(const core::HandModel& hand, const core::Pose& pose) {
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

/// Central differences of f(retract(pose, step)) at step = 0, one column per degree of freedom.
template <typename Function>
Eigen::MatrixXd differencesByStep(const core::Pose& pose, Function&& f) {
    constexpr double kStep = 1e-4;
    Eigen::MatrixXd jacobian;
    for (Eigen::Index k = 0; k < pose.size(); ++k) {
        const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(pose.size(), k);
        const Eigen::VectorXd column = (f(core::retract(pose, step)) - f(core::retract(pose, -step))) / (2 * kStep);
        if (jacobian.size() == 0)
            jacobian.resize(column.size(), pose.size());
        jacobian.col(k) = column;
    }
    return jacobian;
}

} // namespace test
