// SPDX-License-Identifier: MIT
#include "core/fitting/joint_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "core/numeric/box_step.h"

namespace core {

namespace {

Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& points) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
        sum += point;
    }
    return sum / static_cast<double>(points.size());
}

/// The least-squares problem: targets with square roots of their information, and the prior on angles.
class Problem {
public:
    Problem(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& start, const JointFitOptions& options)
        : m_skeleton(skeleton), m_targets(targets), m_start(start), m_priorWeight(1 / (options.priorSigmaRad * options.priorSigmaRad)) {
        for (const JointTarget& target : targets) {
            const Eigen::Matrix3d covariance =
                target.covariance + options.modelSigmaMm * options.modelSigmaMm * Eigen::Matrix3d::Identity();
            m_information.push_back(covariance.inverse());
        }
    }

    double cost(const Pose& pose) const {
        const auto joints = jointPositions(m_skeleton, pose);
        double sum = 0;
        for (std::size_t i = 0; i < m_targets.size(); ++i) {
            const Eigen::Vector3d residual = residualOf(i, joints);
            sum += residual.dot(m_information[i] * residual);
        }
        return 0.5 * (sum + m_priorWeight * anglesFromStart(pose).squaredNorm());
    }

    void linearise(const Pose& pose, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
        const auto joints = jointPositions(m_skeleton, pose);
        const Eigen::MatrixXd jacobian = jointJacobian(m_skeleton, pose);
        hessian.setZero(pose.size(), pose.size());
        gradient.setZero(pose.size());
        for (std::size_t i = 0; i < m_targets.size(); ++i) {
            const auto rows = jacobian.middleRows<3>(3 * m_targets[i].bone);
            const Eigen::MatrixXd weighted = m_information[i] * rows;
            hessian += rows.transpose() * weighted;
            gradient += weighted.transpose() * residualOf(i, joints);
        }
        const auto angles = pose.size() - kRigidDofs;
        hessian.diagonal().tail(angles).array() += m_priorWeight;
        gradient.tail(angles) += m_priorWeight * anglesFromStart(pose);
    }

    std::vector<double> residuals(const Pose& pose) const {
        const auto joints = jointPositions(m_skeleton, pose);
        std::vector<double> lengths;
        for (std::size_t i = 0; i < m_targets.size(); ++i) {
            lengths.push_back(residualOf(i, joints).norm());
        }
        return lengths;
    }

private:
    Eigen::Vector3d residualOf(std::size_t target, const std::vector<Eigen::Vector3d>& joints) const {
        return joints[static_cast<std::size_t>(m_targets[target].bone)] - m_targets[target].pointInWorld;
    }
    Eigen::VectorXd anglesFromStart(const Pose& pose) const {
        const auto angles = pose.size() - kRigidDofs;
        return pose.tail(angles) - m_start.tail(angles);
    }

    const Skeleton& m_skeleton;
    const std::vector<JointTarget>& m_targets;
    Pose m_start;
    double m_priorWeight;
    std::vector<Eigen::Matrix3d> m_information;
};

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value * value;
    }
    return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

/// How far each entry of a pose may move; without limits, anywhere.
struct Box {
    Eigen::VectorXd lower, upper;
};

Box stepBox(const Skeleton& skeleton, const Pose& pose, bool withLimits) {
    constexpr double kFree = std::numeric_limits<double>::infinity();
    Box box{Eigen::VectorXd::Constant(pose.size(), -kFree), Eigen::VectorXd::Constant(pose.size(), kFree)};
    for (std::size_t d = 0; withLimits && d < skeleton.dofs.size(); ++d) {
        const auto k = kRigidDofs + static_cast<Eigen::Index>(d);
        box.lower[k] = std::min(0.0, skeleton.dofs[d].minRad - pose[k]);
        box.upper[k] = std::max(0.0, skeleton.dofs[d].maxRad - pose[k]);
    }
    return box;
}

Pose clampedToLimits(const Skeleton& skeleton, Pose pose) {
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        double& angle = pose[kRigidDofs + static_cast<Eigen::Index>(d)];
        angle = std::clamp(angle, skeleton.dofs[d].minRad, skeleton.dofs[d].maxRad);
    }
    return pose;
}

/// Damped Gauss-Newton from fit.pose.
void solve(const Skeleton& skeleton, const Problem& problem, const JointFitOptions& options, JointFit& fit) {
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
    double damping = 1e-4;
    double cost = problem.cost(fit.pose);
    for (int i = 0; i < options.maxIterations; ++i) {
        fit.history.push_back({i, cost, rootMeanSquare(problem.residuals(fit.pose))});
        problem.linearise(fit.pose, hessian, gradient);
        Eigen::MatrixXd damped = hessian;
        damped.diagonal() *= 1 + damping;
        damped.diagonal().array() += 1e-9;
        const Box box = stepBox(skeleton, fit.pose, options.withLimits);
        const Eigen::VectorXd step = boxConstrainedStep(damped, gradient, box.lower, box.upper);
        const Pose candidate = retract(fit.pose, step);
        const double next = problem.cost(candidate);
        if (next <= cost) {
            fit.pose = candidate;
            cost = next;
            damping = std::max(1e-9, damping / 10);
        } else {
            damping *= 10;
        }
        if (step.cwiseAbs().maxCoeff() < options.minStep) {
            fit.converged = true;
            return;
        }
    }
}

} // namespace

std::optional<Pose> alignedToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& pose) {
    if (targets.size() < 3) {
        return std::nullopt;
    }
    const auto joints = jointPositions(skeleton, pose);
    std::vector<Eigen::Vector3d> from, to;
    for (const JointTarget& target : targets) {
        from.push_back(joints[static_cast<std::size_t>(target.bone)]);
        to.push_back(target.pointInWorld);
    }
    const Eigen::Vector3d fromMean = mean(from), toMean = mean(to);
    Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        correlation += (to[i] - toMean) * (from[i] - fromMean).transpose();
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
    constexpr double kOnALine = 1e-6; // relative size of the second singular value
    if (!(svd.singularValues()[1] > kOnALine * svd.singularValues()[0])) {
        return std::nullopt;
    }
    Eigen::Matrix3d fix = Eigen::Matrix3d::Identity();
    fix(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    const Eigen::Matrix3d turn = svd.matrixU() * fix * svd.matrixV().transpose();
    // worldFromRoot = Translate(centre + translation) exp(rotation) ...: turning the world moves the hand's centre along.
    Pose aligned = pose;
    const Eigen::Vector3d centre = skeleton.centreAtRest + pose.head<3>();
    aligned.head<3>() = turn * (centre - fromMean) + toMean - skeleton.centreAtRest;
    aligned.segment<3>(3) = rotationLog(turn * rotationExp(pose.segment<3>(3)));
    return aligned;
}

std::optional<JointFit> fitPoseToJoints(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& start,
                                        const JointFitOptions& options) {
    const Pose begin = options.withLimits ? clampedToLimits(skeleton, start) : start;
    const auto aligned = alignedToJoints(skeleton, targets, begin);
    if (!aligned) {
        return std::nullopt;
    }
    JointFit fit;
    fit.pose = *aligned;
    const Problem problem(skeleton, targets, begin, options);
    solve(skeleton, problem, options, fit);
    fit.residualMm = problem.residuals(fit.pose);
    fit.rmsMm = rootMeanSquare(fit.residualMm);
    return fit;
}

} // namespace core
