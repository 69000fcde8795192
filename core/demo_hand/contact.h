// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace core {

/// Room between two surfaces along `direction` (unit, from the first to the second): how far the second may move
/// against it until they touch; negative if it has to move along it. Surfaces that do not face each other give
/// infinity. Sampled on a grid of `cellMm`.
double gapAlong(const Eigen::Vector3d& direction, const std::vector<Eigen::Vector3d>& first,
                const std::vector<std::array<int, 3>>& firstTriangles, const std::vector<Eigen::Vector3d>& second,
                const std::vector<std::array<int, 3>>& secondTriangles, double cellMm = 1.5);

} // namespace core
