// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"
#include "core/geometry/triangulation.h"

namespace core {

/// How far a click lies off the curve on which another view's click says that the joint is (its epipolar curve).
/// Recorded (distorted) pixels of the click's own camera.
struct CurveGap {
    std::string camera;  ///< of the click
    std::string curveOf; ///< camera whose click makes the curve
    double px = 0;       ///< from the click to the nearest point of the curve
    Eigen::Vector2d clickPx = Eigen::Vector2d::Zero();
    Eigen::Vector2d nearestPx = Eigen::Vector2d::Zero(); ///< on the curve
};

/// Of all pairs of clicks, the one whose clicks lie farthest off each other's curves: the gap in either view, the
/// larger one first; one gap if only one of the two sees the other's ray, none if no view sees the ray of another
/// click.
std::vector<CurveGap> worstCurveGaps(const std::vector<Camera>& cameras, const std::vector<Observation>& clicks);

} // namespace core
