// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/detection/hand_landmarks.h"
#include "core/geometry/camera.h"
#include "core/geometry/triangulation.h"

namespace core {

/// The hands that the detector found in the pictures of one instant, by camera.
using ViewDetections = std::vector<std::vector<DetectedHand>>;

/// A landmark in space. `triangulated` is over `cameras`, in this order; its covariance includes the part of the
/// detector's error that all views share.
struct SpatialLandmark {
    TriangulatedPoint triangulated;
    std::vector<int> cameras;
};

/// A hand that several views agree about.
struct SpatialHand {
    std::array<std::optional<SpatialLandmark>, kLandmarkCount> landmarks;
    std::map<int, DetectedHand> views; ///< by camera

    int landmarkCount() const;
    /// Sum of the views' log odds that it is a right hand, each within +-3.
    double rightnessLogOdds() const;
    /// Median over landmarks and views of the distance of detection and reprojection, share of the square's side.
    double medianResidual() const;
};

/// The landmarks of one hand in the views that saw it.
SpatialHand spatialHand(const std::vector<Camera>& cameras, std::map<int, DetectedHand> views);

/// Joins detections of different cameras into hands, whatever side the detector thinks them to be: pairs of detections
/// whose landmarks meet in space propose a hand, the one that most views confirm wins, its detections are taken, and so
/// on. At most `mostHands`, those with most views first. Deterministic.
std::vector<SpatialHand> groupDetections(const std::vector<Camera>& cameras, const ViewDetections& detections,
                                         std::size_t mostHands = 2);

/// Where a hand's landmarks appear in a camera; none if too few of them are known or in front of it.
std::optional<LandmarkPixels> projectHand(const Camera& camera, const SpatialHand& hand);

/// Mean distance of the landmarks that both hands have, mm; infinity if there are few.
double meanDistanceMm(const SpatialHand& a, const SpatialHand& b);

} // namespace core
