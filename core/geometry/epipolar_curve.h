// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"

namespace core {

/// Points in recorded pixels, joined by straight segments.
using Polyline = std::vector<Eigen::Vector2d>;

/// Which part of a ray is drawn: distances from its camera in mm.
struct RayRange {
    double nearMm = 1;
    double farMm = 1e7;
};

/// The viewing ray of `px` in camera `from` as camera `to` records it: bent by the lens of `to`, any direction
/// (vertical too), cut at the border of its image (half a pixel outside the outermost centres). Points run from near to
/// far and lie at most 1/48 of the visible part apart. Empty if `to` does not see the ray, if the lens cannot be
/// inverted at `px`, or if both cameras have the same centre.
Polyline epipolarCurve(const Camera& from, const Eigen::Vector2d& px, const Camera& to, const RayRange& range = {});

/// The point of the polyline that is nearest to `px`; empty if it has fewer than two points.
std::optional<Eigen::Vector2d> nearestOnPolyline(const Polyline& polyline, const Eigen::Vector2d& px);

} // namespace core
