// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/detection/hand_views.h"
#include "core/fitting/joint_problem.h"
#include "core/hand/hand_model.h"

namespace core {

/// Where the detector's landmarks are expected of a posed model, in a unit of so many mm: only their places are known.
SpatialHand landmarksOf(const HandModel& hand, const Pose& pose, double unitMm);

struct LandmarkFitOptions {
    /// The hands' joints are what the detector calls so, because nobody says otherwise: its mean error stays on.
    bool areJoints = false;
    double modelSigmaMm = 2;    ///< how far the model's joints are from the person's
    double priorSigmaRad = 0.6; ///< how far angles are expected from those of a start
    std::size_t certain = 0;    ///< of fitToTargets: so many first targets are never taken for outliers
};

/// The joints of a model that landmarks stand for, by name, the detector's mean error taken off. A model without a
/// wrist has its root there, a little off; people and models also differ about where the thumb begins: both get a wide
/// covariance. Tips count if the model has bones for them (withTips).
std::vector<JointTarget> landmarkTargets(const HandModel& hand, const SpatialHand& detected, bool areJoints = false);

/// A hand model in the pose that landmarks ask for.
struct LandmarkFit {
    Pose pose;
    std::vector<Eigen::Matrix3d> jointCovarianceMm2; ///< per bone
    /// Mean squared Mahalanobis distance per coordinate of the targets: about 1 where the model explains them, much
    /// more for the other side's hand.
    double misfit = 0;
};

/// The pose whose joints explain the landmarks best: from each of `starts` (angles count; the hand is brought to the
/// landmarks), outlying landmarks weighed down (Cauchy), the least cost wins. No value with fewer than three landmarks
/// or with landmarks on a line.
std::optional<LandmarkFit> fitToLandmarks(const HandModel& hand, const SpatialHand& detected,
                                          const std::vector<Pose>& starts, const LandmarkFitOptions& options = {});

/// Poses to start from when nothing is known: fingers straight, half bent and bent.
std::vector<Pose> usualStarts(const Skeleton& skeleton);

/// The same for joints as a person has corrected them; targets as clicks give them.
std::optional<LandmarkFit> fitToTargets(const HandModel& hand, const std::vector<JointTarget>& targets,
                                        const std::vector<Pose>& starts, const LandmarkFitOptions& options = {});

} // namespace core
