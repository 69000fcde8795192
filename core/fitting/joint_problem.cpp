// SPDX-License-Identifier: MIT
#include "core/fitting/joint_problem.h"

#include <algorithm>
#include <limits>

#include <Eigen/LU>

namespace core {

JointProblem::JointProblem(const Skeleton& skeleton, const std::vector<JointTarget>& targets, const Pose& start,
                           const JointProblemOptions& options)
    : m_skeleton(skeleton)
    , m_targets(targets)
    , m_start(start)
    , m_withLimits(options.withLimits)
    , m_priorWeight(1 / (options.priorSigmaRad * options.priorSigmaRad)) {
    for (const JointTarget& target : targets) {
        const Eigen::Matrix3d covariance =
            target.covariance + options.modelSigmaMm * options.modelSigmaMm * Eigen::Matrix3d::Identity();
        m_information.push_back(covariance.inverse());
    }
}

double JointProblem::cost(const Pose& pose) const {
    const auto joints = jointPositions(m_skeleton, pose);
    double sum = 0;
    for (std::size_t i = 0; i < m_targets.size(); ++i) {
        const Eigen::Vector3d residual = residualOf(i, joints);
        sum += residual.dot(m_information[i] * residual);
    }
    return 0.5 * (sum + m_priorWeight * anglesFromStart(pose).squaredNorm());
}

void JointProblem::linearise(const Pose& pose, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
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

StepBox JointProblem::stepBox(const Pose& pose) const {
    constexpr double kFree = std::numeric_limits<double>::infinity();
    StepBox box{Eigen::VectorXd::Constant(pose.size(), -kFree), Eigen::VectorXd::Constant(pose.size(), kFree)};
    for (std::size_t d = 0; m_withLimits && d < m_skeleton.dofs.size(); ++d) {
        const auto k = kRigidDofs + static_cast<Eigen::Index>(d);
        box.lower[k] = std::min(0.0, m_skeleton.dofs[d].minRad - pose[k]);
        box.upper[k] = std::max(0.0, m_skeleton.dofs[d].maxRad - pose[k]);
    }
    return box;
}

std::vector<double> JointProblem::distancesMm(const Pose& pose) const {
    const auto joints = jointPositions(m_skeleton, pose);
    std::vector<double> lengths;
    for (std::size_t i = 0; i < m_targets.size(); ++i)
        lengths.push_back(residualOf(i, joints).norm());
    return lengths;
}

Eigen::Vector3d JointProblem::residualOf(std::size_t target, const std::vector<Eigen::Vector3d>& joints) const {
    return joints[static_cast<std::size_t>(m_targets[target].bone)] - m_targets[target].pointInWorld;
}

Eigen::VectorXd JointProblem::anglesFromStart(const Pose& pose) const {
    const auto angles = pose.size() - kRigidDofs;
    return pose.tail(angles) - m_start.tail(angles);
}

namespace {

/// Targets alone: no prior on the angles, no limits.
JointProblem problemOf(const Skeleton& skeleton, const std::vector<JointTarget>& joints, const Pose& pose) {
    JointProblemOptions options;
    options.modelSigmaMm = 1;
    options.priorSigmaRad = std::numeric_limits<double>::infinity();
    options.withLimits = false;
    return {skeleton, joints, pose, options};
}

} // namespace

KnownJointEquations knownJointEquations(const Skeleton& skeleton, const std::vector<JointTarget>& joints,
                                        const Pose& pose) {
    KnownJointEquations equations;
    problemOf(skeleton, joints, pose).linearise(pose, equations.hessian, equations.gradient);
    return equations;
}

double knownJointMisfit(const std::vector<HandModel>& hands, const KnownJoints& known, const HandPoses& poses) {
    double sum = 0;
    for (std::size_t h = 0; h < known.size() && h < hands.size(); ++h)
        if (!known[h].empty())
            sum += 2 * problemOf(hands[h].skeleton, known[h], poses[h]).cost(poses[h]);
    return sum;
}

} // namespace core
