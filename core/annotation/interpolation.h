// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include <Eigen/Core>

namespace core {

enum class Interpolation {
    Linear,
    Cubic ///< piecewise cubic through the points, tangents from parabolas through three neighbours: exact for parabolas
};

/// The value at `frame` of a curve through `points` (frame -> mm); empty outside of their range. At a point's frame,
/// the point itself. Cubic falls back to linear with two points.
std::optional<Eigen::Vector3d> interpolated(const std::map<int, Eigen::Vector3d>& points, int frame,
                                            Interpolation kind);

} // namespace core
