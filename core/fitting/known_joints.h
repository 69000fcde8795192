// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/fitting/joint_problem.h"
#include "core/hand/hand_model.h"

namespace core {

/// Joints that are known beside the silhouettes, such as those that a person has placed, per hand. Fewer lists than
/// hands: nothing is known of the others.
using KnownJoints = std::vector<std::vector<JointTarget>>;

/// What known joints add to the normal equations of a hand's pose, sum_i J_i^T W_i J_i and sum_i J_i^T W_i r_i with
/// W_i = (C_i + (1 mm)^2 I)^-1: the model's joints are not quite the person's.
struct KnownJointEquations {
    Eigen::MatrixXd hessian;  ///< poseSize x poseSize, per mm^2 or rad^2
    Eigen::VectorXd gradient; ///< by a tangent step of the pose
};
KnownJointEquations knownJointEquations(const Skeleton& skeleton, const std::vector<JointTarget>& joints,
                                        const Pose& pose);

/// Sum over the known joints of all hands of their squared Mahalanobis distances from the models' joints, by W_i.
double knownJointMisfit(const std::vector<HandModel>& hands, const KnownJoints& known, const HandPoses& poses);

} // namespace core
