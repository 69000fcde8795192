// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/detection/hand_views.h"
#include "core/hand/hand_model.h"

namespace core {

/// How far a model's joints are from where the detector sees them, mean over the landmarks, mm; none if there are few
/// to compare.
std::optional<double> landmarkDistanceMm(const HandModel& hand, const Pose& pose, const SpatialHand& detected,
                                         bool areJoints = false);

/// Sine of the angle nearest to a right one that two of a hand's views make at the mean of its landmarks: 1 where they
/// cross at right angles, 0 where one view follows or faces the other, so that depth along them is a guess.
double widestRaySine(const std::vector<Camera>& cameras, const SpatialHand& hand);

/// What speaks for and against a fitted hand.
struct FitSigns {
    double deepPx = 0;                               ///< of the silhouettes, FitConfidence::deepPx
    double overlap = 1;                              ///< intersection over union of the silhouettes
    double worstSigmaMm = 0;                         ///< standard deviation of its least certain joint
    std::optional<double> landmarkMm = std::nullopt; ///< landmarkDistanceMm
    double misfit = 0;                               ///< LandmarkFit::misfit, of a pose from landmarks alone
    double raySine = 1;                              ///< widestRaySine, of a pose from landmarks alone
};

/// 0 sure .. 1 lost: one minus the product of what each sign leaves of the trust (docs/method.md).
double doubtOf(const FitSigns& signs);

} // namespace core
