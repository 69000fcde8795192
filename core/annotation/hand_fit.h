// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/annotation/sequence_points.h"
#include "core/fitting/joint_fit.h"
#include "core/hand/hand_model.h"

namespace core {

/// The pose of a hand model that explains the 3D joints of its side, weighted by their covariances, from the rest pose.
/// Joints that are not origins of bones take no part. No value with fewer than three, or with joints on a line.
std::optional<JointFit> fitHandToPoints(const HandModel& hand, const JointPoints& points);

} // namespace core
