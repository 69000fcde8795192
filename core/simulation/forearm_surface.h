// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/hand/hand_model.h"

namespace core {

/// An arm as a closed tube of triangles, in the world, mm.
struct ForearmSurface {
    std::vector<Eigen::Vector3d> verticesInWorld;
    std::vector<Eigen::Vector3d> normalsInWorld; ///< unit, outward, parallel to the vertices
    std::vector<std::array<int, 3>> triangles;
};

/// The arm that a posed hand hangs on: from the hand's root away from its knuckles, 25 mm thick (radius) at the wrist
/// and 38 mm 260 mm farther on, and from there on.
ForearmSurface forearmSurface(const HandModel& hand, const Pose& pose, double lengthMm = 260);

} // namespace core
