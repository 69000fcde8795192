// SPDX-License-Identifier: MIT
#include "core/fitting/joint_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace core {

namespace {

Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& points) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

Pose clampedToLimits(const Skeleton& skeleton, Pose pose) {
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        double& angle = pose[kRigidDofs + static_cast<Eigen::Index>(d)];
        angle = std::clamp(angle, skeleton.dofs[d].minRad, skeleton.dofs[d].maxRad);
    }
    return pose;
}

} // namespace

std::optional<Pose> alignedToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets,
                                    const Pose& pose) {
    if (targets.size() < 3)
        return std::nullopt;
    const auto joints = jointPositions(skeleton, pose);
    std::vector<Eigen::Vector3d> from, to;
    for (const JointTarget& target : targets) {
        from.push_back(joints[static_cast<std::size_t>(target.bone)]);
        to.push_back(target.pointInWorld);
    }
    const Eigen::Vector3d fromMean = mean(from), toMean = mean(to);
    Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i)
        correlation += (to[i] - toMean) * (from[i] - fromMean).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
    constexpr double kOnALine = 1e-6; // relative size of the second singular value
    if (!(svd.singularValues()[1] > kOnALine * svd.singularValues()[0]))
        return std::nullopt;
    Eigen::Matrix3d fix = Eigen::Matrix3d::Identity();
    fix(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    const Eigen::Matrix3d turn = svd.matrixU() * fix * svd.matrixV().transpose();
    // worldFromRoot = Translate(centre + translation) exp(rotation) ...: turning the world moves the hand's centre
    // along.
    Pose aligned = pose;
    const Eigen::Vector3d centre = skeleton.centreAtRest + pose.head<3>();
    aligned.head<3>() = turn * (centre - fromMean) + toMean - skeleton.centreAtRest;
    aligned.segment<3>(3) = rotationLog(turn * rotationExp(pose.segment<3>(3)));
    return aligned;
}

std::optional<JointFit> fitPoseToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets,
                                        const Pose& start, const JointFitOptions& options) {
    const Pose begin = options.withLimits ? clampedToLimits(skeleton, start) : start;
    const auto aligned = alignedToJoints(skeleton, targets, begin);
    if (!aligned)
        return std::nullopt;
    const JointProblem problem(skeleton, targets, begin, options);
    SolverOptions solver;
    solver.maxIterations = options.maxIterations;
    solver.minStep = options.minStep;
    solver.initialDamping = 1e-4;
    solver.minDamping = 1e-9;
    solver.diagonalFloor = 1e-9;
    JointFit fit;
    fit.pose = *aligned;
    fit.summary = levenbergMarquardt(problem, solver, fit.pose);
    fit.residualMm = problem.distancesMm(fit.pose);
    fit.rmsMm = rootMeanSquare(fit.residualMm);
    return fit;
}

} // namespace core
