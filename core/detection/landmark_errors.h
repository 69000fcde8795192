// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "core/detection/hand_views.h"
#include "core/hand/skeleton.h"

namespace core {

/// The detector's mean error in space, taken off: where a landmark is from the joint that it stands for, in the joint's
/// frame (landmarkFrame), as a share of the palm's length. Landmarks whose error is not known stay, and all do where
/// the palm is not. Residuals and covariances stay those of the detections.
SpatialHand withoutBias(SpatialHand hand, Side side);

/// A landmark's own frame as columns: y from the joint before it, z out of the palm's plane on the side of its back or
/// palm that is the same for both hands, x so that left and right hands mirror each other. Empty if landmarks that it
/// takes are unknown or lie on a line.
std::optional<Eigen::Matrix3d> landmarkFrame(const SpatialHand& hand, std::size_t landmark, Side side);

} // namespace core
