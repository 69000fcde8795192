// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "core/annotation/annotation_set.h"
#include "core/hand/hand_model.h"

namespace core {

/// Where joints are, in the world, mm.
using JointPositions = std::map<JointId, Eigen::Vector3d>;

/// Names of all joints of the hands, hand by hand, bones in their order.
std::vector<JointId> jointNames(const std::vector<HandModel>& hands);
/// All joints of the hands in the given poses.
JointPositions namedJointPositions(const std::vector<HandModel>& hands, const HandPoses& poses);

/// As results are kept: rounded to six decimals.
double toMillionths(double value);

/// Euclidean distances between two sets of joints, mm, rounded to 1e-6 mm.
struct JointErrors {
    double meanMm = 0;              ///< over the joints that both have; NaN if there are none
    std::vector<double> perJointMm; ///< parallel to `joints`; NaN where either is missing
};
JointErrors jointErrors(const std::vector<JointId>& joints, const JointPositions& estimate,
                        const JointPositions& reference);

} // namespace core
