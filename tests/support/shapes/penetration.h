// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace test {

/// How deep the deepest of `points` lies inside a closed surface, mm; 0 if none is inside. Inside is told by counting
/// crossings of a ray, depth is the distance to the nearest triangle.
double deepestInside(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& vertices,
                     const std::vector<std::array<int, 3>>& triangles);

/// Distance from a point to a triangle.
double distanceToTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c);

} // namespace test
