// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"

namespace core {

/// Where the cameras look: the point x nearest to all optical axes (c_i, d_i), world, mm. Least squares:
/// sum (I - d_i d_i^T) x = sum (I - d_i d_i^T) c_i. No value if the axes are parallel to within about half a degree or
/// there is only one. Its distance from the cameras shows a wrong unit or a transposed rotation at a glance.
std::optional<Eigen::Vector3d> commonTarget(const std::vector<Camera>& cameras);

/// The same for any number of cameras but none: where the axes leave x open, the solution nearest to the world's
/// origin.
Eigen::Vector3d commonTargetNearOrigin(const std::vector<Camera>& cameras);

} // namespace core
