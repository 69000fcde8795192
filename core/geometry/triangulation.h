// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"

namespace core {

/// A click: which camera (index into the camera list) and the recorded pixel.
struct Observation {
    int camera = 0;
    Eigen::Vector2d px;
};

struct TriangulationOptions {
    double sigmaPx = 1.0;           ///< standard deviation of a click per axis, px
    double outlierFactor = 4.0;     ///< a view is an outlier if its residual > outlierFactor * sigmaPx
    double minAngleRad = 0.0175;    ///< widest angle between two rays below which there is no answer (1 degree)
    int maxIterations = 20;
};

/// A point from clicks in N views. rmsPx and covariance are over the inliers only.
struct TriangulatedPoint {
    Eigen::Vector3d pointInWorld;   ///< mm
    Eigen::Matrix3d covariance;     ///< sigma^2 (sum J^T J)^-1, mm^2
    double rmsPx = 0;               ///< root mean square pixel distance over the views used
    std::vector<double> residualPx; ///< distance per observation, px, outliers too
    std::vector<bool> inlier;       ///< per observation
};

/// Either a point, or why there is none (one of a fixed set of English phrases, translated by the window).
struct TriangulationResult {
    std::optional<TriangulatedPoint> point;
    std::string reason;
};

/// Robust N-view triangulation: every pair of views proposes a point, MSAC in recorded pixels chooses, Gauss-Newton over
/// the inliers refines what is reported (distorted pixels). Deterministic: all pairs, no sampling.
TriangulationResult triangulate(const std::vector<Camera>& cameras, const std::vector<Observation>& observations,
                                const TriangulationOptions& options = {});

} // namespace core
