// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/rigid_motion.h"
#include "core/hand/hand_model.h"

namespace test {

/// The motion of every bone from the rest pose by the product of exponentials (Murray, Li, Sastry 1994): all twists are
/// those of the rest pose. An oracle that shares no kinematics with the skeleton's own walk along the tree.
std::vector<core::RigidMotion> spatialMotions(const core::Skeleton& skeleton, const core::Pose& pose);

/// v(theta) = sum_j a_vj T_j(theta) v.
std::vector<Eigen::Vector3d> spatiallyPosed(const core::HandModel& hand, const core::Pose& pose);

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
