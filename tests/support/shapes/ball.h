// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace test {

/// A closed ball of triangles, counter-clockwise from outside, with exact normals. mm.
struct Ball {
    std::vector<Eigen::Vector3d> vertices, normals;
    std::vector<std::array<int, 3>> triangles;
};

Ball makeBall(const Eigen::Vector3d& centre, double radius, int rings = 24, int sectors = 48);

} // namespace test
