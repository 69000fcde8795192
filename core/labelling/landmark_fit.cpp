// SPDX-License-Identifier: MIT
#include "core/labelling/landmark_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/detection/landmark_errors.h"
#include "core/fitting/fit_confidence.h"
#include "core/fitting/joint_fit.h"

namespace core {

namespace {

constexpr double kRootSigmaMm = 10; ///< of a root that stands for the wrist
constexpr double kThumbSigmaMm = 6; ///< of where the thumb begins
constexpr int kRobustRounds = 3;
constexpr double kCauchySigmas = 2;

/// Squared Mahalanobis distance of every target in a pose, the model's own deviation included.
std::vector<double> squaredDistances(const Skeleton& skeleton, const std::vector<JointTarget>& targets,
                                     const Pose& pose, double modelSigmaMm) {
    const auto joints = jointPositions(skeleton, pose);
    std::vector<double> squared;
    for (const JointTarget& target : targets) {
        const Eigen::Vector3d residual = joints[static_cast<std::size_t>(target.bone)] - target.pointInWorld;
        const Eigen::Matrix3d covariance =
            target.covariance + modelSigmaMm * modelSigmaMm * Eigen::Matrix3d::Identity();
        squared.push_back(residual.dot(covariance.llt().solve(residual)));
    }
    return squared;
}

/// The cost of a pose: outlying targets count by the logarithm of their distance, certain ones as they are.
double robustCost(const std::vector<double>& squared, std::size_t certain) {
    constexpr double kScale = 3 * kCauchySigmas * kCauchySigmas;
    double cost = 0;
    for (std::size_t i = 0; i < squared.size(); ++i)
        cost += i < certain ? squared[i] : kScale * std::log1p(squared[i] / kScale);
    return cost;
}

/// Targets whose covariance is wider the farther they were off.
std::vector<JointTarget> reweighed(std::vector<JointTarget> targets, const std::vector<double>& squared,
                                   const LandmarkFitOptions& options) {
    constexpr double kScale = 3 * kCauchySigmas * kCauchySigmas;
    const Eigen::Matrix3d model = options.modelSigmaMm * options.modelSigmaMm * Eigen::Matrix3d::Identity();
    for (std::size_t i = options.certain; i < targets.size(); ++i)
        targets[i].covariance = (1 + squared[i] / kScale) * (targets[i].covariance + model) - model;
    return targets;
}

std::optional<Pose> robustFit(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& start,
                              const LandmarkFitOptions& options) {
    JointFitOptions fitOptions;
    fitOptions.modelSigmaMm = options.modelSigmaMm;
    fitOptions.priorSigmaRad = options.priorSigmaRad;
    fitOptions.maxIterations = 30;
    fitOptions.minStep = 1e-4;
    std::vector<JointTarget> weighed = targets;
    std::optional<Pose> pose;
    for (int round = 0; round < kRobustRounds; ++round) {
        const auto fit = fitPoseToJoints(skeleton, weighed, start, fitOptions);
        if (!fit)
            return std::nullopt;
        pose = fit->pose;
        weighed = reweighed(targets, squaredDistances(skeleton, targets, *pose, options.modelSigmaMm), options);
    }
    return pose;
}

/// Of every bone's origin, from the normal equations of the targets and the prior.
std::vector<Eigen::Matrix3d> covariancesAt(const Skeleton& skeleton, const std::vector<JointTarget>& targets,
                                           const Pose& pose, const LandmarkFitOptions& options) {
    JointProblemOptions problemOptions;
    problemOptions.modelSigmaMm = options.modelSigmaMm;
    problemOptions.priorSigmaRad = options.priorSigmaRad;
    const auto weighed = reweighed(targets, squaredDistances(skeleton, targets, pose, options.modelSigmaMm), options);
    const JointProblem problem(skeleton, weighed, pose, problemOptions);
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
    problem.linearise(pose, hessian, gradient);
    hessian.diagonal().array() += 1e-6;
    return jointCovariances(skeleton, pose,
                            hessian.ldlt().solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols())));
}

} // namespace

std::vector<JointTarget> landmarkTargets(const HandModel& hand, const SpatialHand& detected, bool areJoints) {
    const SpatialHand unbiased = areJoints ? detected : withoutBias(detected, hand.side);
    const bool hasWrist = hand.skeleton.boneIndex(landmarkName(kWristLandmark)) >= 0;
    std::vector<JointTarget> targets;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        if (!unbiased.landmarks[i])
            continue;
        const std::string_view name = landmarkName(i);
        const bool isRoot = i == kWristLandmark && !hasWrist;
        const int bone = isRoot ? 0 : hand.skeleton.boneIndex(name);
        if (bone < 0)
            continue;
        const double sigma = isRoot ? kRootSigmaMm : name == "thumb_cmc" && !areJoints ? kThumbSigmaMm : 0;
        targets.push_back(
            {bone, unbiased.landmarks[i]->triangulated.pointInWorld,
             unbiased.landmarks[i]->triangulated.covariance + sigma * sigma * Eigen::Matrix3d::Identity()});
    }
    return targets;
}

SpatialHand landmarksOf(const HandModel& hand, const Pose& pose, double unitMm) {
    const auto joints = jointPositions(hand.skeleton, pose);
    SpatialHand result;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        const int bone = i == kWristLandmark ? 0 : hand.skeleton.boneIndex(landmarkName(i));
        if (bone < 0)
            continue;
        result.landmarks[i].emplace();
        result.landmarks[i]->triangulated.pointInWorld = joints[static_cast<std::size_t>(bone)] / unitMm;
    }
    return result;
}

std::vector<Pose> usualStarts(const Skeleton& skeleton) {
    constexpr double kWideRad = 1; // bends of fingers, not spreads and twists
    std::vector<Pose> starts;
    for (const double share : {0.0, 0.35, 0.7}) {
        Pose pose = skeleton.restPose();
        for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
            const DegreeOfFreedom& dof = skeleton.dofs[d];
            const double bent = -dof.minRad > dof.maxRad ? dof.minRad : dof.maxRad;
            if (dof.maxRad - dof.minRad > kWideRad)
                pose[kRigidDofs + static_cast<Eigen::Index>(d)] = std::clamp(share * bent, dof.minRad, dof.maxRad);
        }
        starts.push_back(std::move(pose));
    }
    return starts;
}

std::optional<LandmarkFit> fitToTargets(const HandModel& hand, const std::vector<JointTarget>& targets,
                                        const std::vector<Pose>& starts, const LandmarkFitOptions& options) {
    std::optional<LandmarkFit> best;
    double leastCost = std::numeric_limits<double>::infinity();
    for (const Pose& start : starts) {
        const auto pose = robustFit(hand.skeleton, targets, start, options);
        if (!pose)
            continue;
        const auto squared = squaredDistances(hand.skeleton, targets, *pose, options.modelSigmaMm);
        const double cost = robustCost(squared, options.certain);
        if (cost >= leastCost)
            continue;
        leastCost = cost;
        best = LandmarkFit{*pose, {}, cost / (3.0 * static_cast<double>(targets.size()))};
    }
    if (best)
        best->jointCovarianceMm2 = covariancesAt(hand.skeleton, targets, best->pose, options);
    return best;
}

std::optional<LandmarkFit> fitToLandmarks(const HandModel& hand, const SpatialHand& detected,
                                          const std::vector<Pose>& starts, const LandmarkFitOptions& options) {
    return fitToTargets(hand, landmarkTargets(hand, detected, options.areJoints), starts, options);
}

} // namespace core
