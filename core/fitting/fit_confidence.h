// SPDX-License-Identifier: MIT
#pragma once

#include "core/fitting/fit_result.h"
#include "core/fitting/pose_refiner.h"

namespace core {

/// Covariance of a hand's pose (tangent step of retract; mm and rad) given its normal equations at the solution:
///     (H / (sigma^2 k) + C^-1 / s^2)^-1
/// sigmaMm: standard deviation of one residual; pointsPerSample: k, how many residuals count as one independent one;
/// changePrecision: C^-1 of the angles (fingerChangePrecision); changeScale: s, how much of such a change there was.
Eigen::MatrixXd poseCovariance(const Eigen::MatrixXd& hessian, double sigmaMm, double pointsPerSample,
                               const Eigen::MatrixXd& changePrecision, double changeScale);

/// J cov J^T for every joint, mm^2; J of the joints by the tangent step.
std::vector<Eigen::Matrix3d> jointCovariances(const Skeleton& skeleton, const Pose& pose,
                                              const Eigen::MatrixXd& poseCovarianceOfHand);

/// The systematic part of a fit's residuals: the linear least-squares problem of all poses, one scale, one girth and a
/// shift of every view's picture, with weak priors on all of them (5 %, 1 mm, 5 px, changes of angles as
/// changePrecision has them) and Cauchy weights. pointsPerSample: see poseCovariance.
SystematicPart systematicPart(const FittingHands& hands, const HandPoses& poses,
                              const std::vector<OutlineResidual>& residuals, double pointsPerSample);

/// Logistic function of what speaks against a fit, with the weights that simulated fits of the demo's hands gave
/// (docs/method.md, "Doubt"): `confidence` with all but the doubt filled in.
double doubtOf(const FitConfidence& confidence);

/// Judges the final poses of a fit. rivalMm: see FitAttempt.
FitConfidence judgeFit(PoseRefiner& refiner, const HandPoses& start, const HandPoses& poses, double rivalMm);

} // namespace core
