// SPDX-License-Identifier: MIT
#include "core/fitting/joint_problem.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/support/problem_checks.h"
#include "tests/support/random_values.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::JointTarget;
using core::Pose;
using Eigen::Matrix3d;

class JointProblem : public testing::Test {
protected:
    std::vector<JointTarget> targetsNear(const Pose& pose) {
        std::vector<JointTarget> targets;
        const auto joints = core::jointPositions(m_skeleton, pose);
        for (std::size_t b = 0; b < joints.size(); ++b) {
            const Matrix3d root = Matrix3d::Identity() + 0.2 * Matrix3d(m_random.vector(9, 1).reshaped(3, 3));
            targets.push_back({static_cast<int>(b), joints[b] + m_random.point(5), root * root.transpose()});
        }
        return targets;
    }

    test::RandomValues m_random{"joint problem"};
    core::Skeleton m_skeleton = test::twoFingerHand(core::Side::Left, {}).skeleton;
};

TEST_F(JointProblem, GradientIsThatOfFiniteDifferences) {
    for (int trial = 0; trial < 10; ++trial) {
        const Pose truth = test::somePose(m_skeleton, m_random, 50, 1),
                   at = test::somePose(m_skeleton, m_random, 50, 1);
        const auto targets = targetsNear(truth);
        test::expectGradient(core::JointProblem(m_skeleton, targets, truth, {}), at, 1e-6);
    }
}

TEST_F(JointProblem, HessianIsThatOfTheStackedJacobians) {
    const Pose truth = test::somePose(m_skeleton, m_random, 50, 1);
    const auto targets = targetsNear(truth);
    const core::JointProblemOptions options;
    const core::JointProblem problem(m_skeleton, targets, truth, options);
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
    problem.linearise(truth, hessian, gradient);
    // The residuals whose squares the cost sums up: whitened joints, then the prior.
    const auto residuals = [&](const Eigen::VectorXd& pose) {
        const auto joints = core::jointPositions(m_skeleton, pose);
        Eigen::VectorXd all(3 * static_cast<Eigen::Index>(targets.size()) + pose.size() - core::kRigidDofs);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const Matrix3d covariance =
                targets[i].covariance + options.modelSigmaMm * options.modelSigmaMm * Matrix3d::Identity();
            const Matrix3d lower = covariance.llt().matrixL();
            all.segment<3>(3 * static_cast<Eigen::Index>(i)) = lower.inverse() * (joints[i] - targets[i].pointInWorld);
        }
        all.tail(pose.size() - core::kRigidDofs) =
            (pose - truth).tail(pose.size() - core::kRigidDofs) / options.priorSigmaRad;
        return all;
    };
    const Eigen::MatrixXd jacobian = test::numericJacobian(problem, truth, residuals);
    EXPECT_LT((hessian - jacobian.transpose() * jacobian).norm(), 1e-6 * hessian.norm());
    EXPECT_NEAR(problem.cost(truth), 0.5 * residuals(truth).squaredNorm(), 1e-9);
}

TEST_F(JointProblem, StepsEndAtTheLimitsOfTheAngles) {
    Pose pose = m_skeleton.restPose();
    pose[core::kRigidDofs] = m_skeleton.dofs[0].maxRad - 0.1;
    const auto targets = targetsNear(pose);
    const core::StepBox box = core::JointProblem(m_skeleton, targets, pose, {}).stepBox(pose);
    EXPECT_NEAR(box.upper[core::kRigidDofs], 0.1, 1e-12);
    EXPECT_NEAR(box.lower[core::kRigidDofs], m_skeleton.dofs[0].minRad - pose[core::kRigidDofs], 1e-12);
    EXPECT_TRUE(std::isinf(box.upper[0]) && std::isinf(box.lower[5]));
    core::JointProblemOptions free;
    free.withLimits = false;
    const core::StepBox open = core::JointProblem(m_skeleton, targets, pose, free).stepBox(pose);
    EXPECT_TRUE(std::isinf(open.upper.minCoeff()) && std::isinf(open.lower.maxCoeff()));
}

} // namespace
