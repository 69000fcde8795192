// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/hand/skeleton.h"

namespace core {

/// Where a joint was annotated, and how surely.
struct JointTarget {
    int bone = 0;                     ///< whose origin it is
    Eigen::Vector3d pointInWorld;     ///< mm
    Eigen::Matrix3d covariance;       ///< mm^2, positive definite
};

struct JointFitOptions {
    double modelSigmaMm = 1.5;    ///< how far the model's joints are from the person's, added to every covariance
    double priorSigmaRad = 0.6;   ///< how far angles are expected from those of the start pose: decides what no target does
    bool withLimits = true;       ///< angles stay within the skeleton's limits
    int maxIterations = 60;
    double minStep = 1e-7;        ///< ends when no entry of a step (mm, rad) exceeds it
};

/// One iteration, before its step.
struct JointFitIteration {
    int iteration = 0;
    double cost = 0;   ///< half the sum of squared Mahalanobis residuals and prior terms
    double rmsMm = 0;  ///< over the targets
};

struct JointFit {
    Pose pose;
    std::vector<double> residualMm;  ///< per target
    double rmsMm = 0;
    bool converged = false;
    std::vector<JointFitIteration> history;
};

/// The rigid part of a pose that brings the joints nearest to their targets while the angles stay as in `pose`: closed form
/// (Umeyama 1991, without scale). Nothing with fewer than three targets or with targets on a line.
std::optional<Pose> alignedToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& pose);

/// The pose whose bone origins explain annotated joints: minimises the Mahalanobis distances to the targets plus a weak pull of the
/// angles towards `start`; damped Gauss-Newton with box constraints on the angles, from `start` turned onto the targets.
/// A start angle outside its limits is moved onto them first. Nothing with fewer than three targets or with targets on a line.
std::optional<JointFit> fitPoseToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& start,
                                        const JointFitOptions& options = {});

} // namespace core
