// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/rig/rig_clicks.h"

namespace core {

/// A click and where the other cameras expect it.
struct RigResidual {
    int joint = 0;                                        ///< index into the joints
    int camera = 0;                                       ///< index into the cameras
    Eigen::Vector2d px = Eigen::Vector2d::Zero();         ///< where it was clicked
    Eigen::Vector2d residualPx = Eigen::Vector2d::Zero(); ///< clicked - projected, the point made from all cameras
    Eigen::Vector2d leftOutPx = Eigen::Vector2d::Zero();  ///< clicked - projected, the point made from the others only
    Eigen::Matrix2d othersPx2 = Eigen::Matrix2d::Zero();  ///< covariance of that projection, px^2
    double weight = 1;                                    ///< near 0 for a click that is wrong by itself
};

/// All clicks of a rig against each other, without a camera being dropped: every joint is placed by weighted least
/// squares over all of its clicks; a camera that disagrees with the others as a whole has a large scatter of its own,
/// and weighs less, but is judged like the others.
struct RigResiduals {
    std::vector<RigResidual> clicks;           ///< of the joints that could be placed, in their order
    std::vector<Eigen::Vector3d> pointInWorld; ///< per joint, mm; NaN where there is none
    std::vector<double> spreadPx;              ///< per camera: click noise and calibration error per axis, px
};

/// Estimates points, spreads and weights in turn (a fixed number of rounds; deterministic). The residual of a left-out
/// view follows from that of the adjustment by its leverage, (I - H)^-1 r with H = J C J^T / spread^2. O(clicks).
RigResiduals computeRigResiduals(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints);

} // namespace core
