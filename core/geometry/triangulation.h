// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"

namespace core {

/// A click: which camera (index into the camera list) and the recorded pixel. A camera may occur more than once
/// (raters).
struct Observation {
    int camera = 0;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    double sigmaPx = 0; ///< its own standard deviation per axis, px; 0 = that of the options
};

struct TriangulationOptions {
    double sigmaPx = 1.0;        ///< standard deviation of a click per axis, px
    double outlierFactor = 4.0;  ///< an observation is an outlier if its residual > outlierFactor * its sigmaPx
    double minAngleRad = 0.0175; ///< widest angle between two rays below which there is no answer (1 degree)
    int maxIterations = 20;
    /// Standard deviation of a click of each camera, px; empty: that of all, `sigmaPx`.
    std::vector<double> sigmaPxByCamera{};
    /// Nobody knows yet how far clicks and cameras are off: the gate of an outlier is at least kAssumedGatePx, and the
    /// covariance grows with residuals that are larger than sigmaPx lets expect (misfitFactor).
    bool isSigmaAssumed = false;
    double systematicPx = 0; ///< the part of the sigmas that is the calibration's and not the clicks', px

    /// Of a click of that camera which has no sigma of its own.
    double sigmaOf(int camera) const {
        const auto index = static_cast<std::size_t>(camera);
        return index < sigmaPxByCamera.size() ? sigmaPxByCamera[index] : sigmaPx;
    }
};

/// While sigma is assumed, clicks nearer than this to where the others put the joint are not outliers: cameras that
/// were calibrated in a hurry differ by so much.
inline constexpr double kAssumedGatePx = 10;

/// By how much a variance is larger than was assumed: (sum of r^2 / sigma^2 + 4) / (degrees of freedom + 4), at least
/// 1; the 4 stand for the assumption, so that few residuals do not outweigh it.
double misfitFactor(double squaresOverSigma2, double degreesOfFreedom);

/// A point from clicks in N views. rmsPx and covariance are over the inliers only.
struct TriangulatedPoint {
    Eigen::Vector3d pointInWorld = Eigen::Vector3d::Zero();   ///< mm
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity(); ///< (sum J^T J / sigma^2)^-1, mm^2
    double rmsPx = 0;                                         ///< root mean square pixel distance over the views used
    std::vector<double> residualPx;                           ///< distance per observation, px, outliers too
    std::vector<bool> inlier;                                 ///< per observation
};

/// Why there is no point.
enum class TriangulationFailure {
    None, ///< there is one
    FewerThanTwoViews,
    OutsideLensModel,   ///< a click lies where the lens model cannot be inverted
    RaysNearlyParallel, ///< no two rays meet at more than TriangulationOptions::minAngleRad
    BehindCamera,       ///< the rays meet behind a camera
    ViewsDisagree       ///< fewer than two clicks lie within the gate of any point
};
/// In English, as files hold it: "fewer than two views"; empty for None.
std::string_view failureText(TriangulationFailure failure);

/// Either a point, or why there is none.
struct TriangulationResult {
    std::optional<TriangulatedPoint> point;
    TriangulationFailure failure = TriangulationFailure::None;
};

/// Robust N-view triangulation: every pair of views proposes a point, MSAC in recorded pixels chooses, Gauss-Newton
/// over the inliers refines what is reported (distorted pixels). Deterministic: all pairs, no sampling. Clicks that the
/// lens model cannot invert propose nothing but are judged like the others. No answer if fewer than two views agree.
TriangulationResult triangulate(const std::vector<Camera>& cameras, const std::vector<Observation>& observations,
                                const TriangulationOptions& options = {});

/// Sum of J^T J / sigma^2 over the cameras that `observations` name, at a point (1/mm^2): the inverse of its
/// covariance. Cameras behind whose plane the point lies add nothing. The pixels are not used.
Eigen::Matrix3d triangulationInformation(const std::vector<Camera>& cameras,
                                         const std::vector<Observation>& observations,
                                         const Eigen::Vector3d& pointInWorld, const TriangulationOptions& options = {});

/// The point that minimises the summed squared residuals (over sigma) of all given observations, from `start`: no
/// outliers are sought. Empty if it leaves the front of a camera or the observations do not fix it.
std::optional<Eigen::Vector3d> refinePoint(const std::vector<Camera>& cameras,
                                           const std::vector<Observation>& observations, const Eigen::Vector3d& start,
                                           const TriangulationOptions& options = {});

} // namespace core
