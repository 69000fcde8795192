// SPDX-License-Identifier: MIT
#include "core/fitting/joint_fit.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/support/five_finger_skeleton.h"

namespace {

using core::JointTarget;
using core::Pose;
using Eigen::Matrix3d;
using Eigen::Vector3d;

class JointFit : public testing::Test {
protected:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }
    Vector3d noise(double sigma) {
        std::normal_distribution<double> normal(0, sigma);
        return {normal(m_random), normal(m_random), normal(m_random)};
    }
    Pose randomPose() {
        Pose pose = m_skeleton.restPose();
        pose.head<3>() = Vector3d(uniform(-300, 300), uniform(-300, 300), uniform(-300, 300));
        pose.segment<3>(3) = Vector3d(uniform(-1.5, 1.5), uniform(-1.5, 1.5), uniform(-1.5, 1.5));
        for (std::size_t d = 0; d < m_skeleton.dofs.size(); ++d) {
            const auto& dof = m_skeleton.dofs[d];
            pose[core::kRigidDofs + static_cast<Eigen::Index>(d)] = uniform(0.8 * dof.minRad, 0.8 * dof.maxRad);
        }
        return pose;
    }
    std::vector<JointTarget> targetsOf(const Pose& pose, double sigmaMm = 0) {
        std::vector<JointTarget> targets;
        const auto joints = core::jointPositions(m_skeleton, pose);
        for (std::size_t b = 0; b < joints.size(); ++b) {
            const double sigma = std::max(sigmaMm, 0.05);
            targets.push_back({static_cast<int>(b), joints[b] + noise(sigmaMm), sigma * sigma * Matrix3d::Identity()});
        }
        return targets;
    }
    double distanceMm(const Pose& a, const Pose& b) {
        const auto first = core::jointPositions(m_skeleton, a), second = core::jointPositions(m_skeleton, b);
        double sum = 0;
        for (std::size_t i = 0; i < first.size(); ++i)
            sum += (first[i] - second[i]).norm() / static_cast<double>(first.size());
        return sum;
    }

    std::mt19937_64 m_random{11};
    core::Skeleton m_skeleton = test::fiveFingerSkeleton(core::Side::Right);
};

TEST_F(JointFit, AlignmentRecoversARigidMotionExactly) {
    for (int trial = 0; trial < 20; ++trial) {
        const Pose truth = randomPose();
        Pose start = truth;
        start.head<3>() = Vector3d(50, -20, 10);
        start.segment<3>(3) = Vector3d(-2, 0.5, 1);
        const auto aligned = core::alignedToJoints(m_skeleton, targetsOf(truth), start);
        ASSERT_TRUE(aligned);
        EXPECT_LT(distanceMm(*aligned, truth), 1e-9);
    }
}

TEST_F(JointFit, FindsThePoseFromExactJointsAndTheRestPose) {
    core::JointFitOptions options;
    options.modelSigmaMm = 0;
    options.priorSigmaRad = 10;
    for (int trial = 0; trial < 20; ++trial) {
        const Pose truth = randomPose();
        const auto fit = core::fitPoseToJoints(m_skeleton, targetsOf(truth), m_skeleton.restPose(), options);
        ASSERT_TRUE(fit);
        EXPECT_EQ(fit->summary.termination, core::SolverTermination::Converged);
        EXPECT_LT(distanceMm(fit->pose, truth), 0.02);
        EXPECT_LT(fit->rmsMm, 0.02);
        const auto& history = fit->summary.history;
        for (std::size_t i = 1; i < history.size(); ++i)
            EXPECT_LE(history[i].cost, history[i - 1].cost);
    }
}

TEST_F(JointFit, ProposesTheJointsThatWereNotAnnotated) {
    double proposed = 0;
    constexpr int kTrials = 20;
    for (int trial = 0; trial < kTrials; ++trial) {
        const Pose truth = test::curledPose(m_skeleton, uniform(0.1, 0.6));
        auto targets = targetsOf(truth, 0.5);
        const auto isLast = [&](const JointTarget& target) {
            const std::string& name = m_skeleton.bones[static_cast<std::size_t>(target.bone)].name;
            return name.ends_with("_tip") || name == "ring_dip" || name == "wrist";
        };
        std::erase_if(targets, isLast);
        const auto fit = core::fitPoseToJoints(m_skeleton, targets, test::curledPose(m_skeleton, 0.35));
        ASSERT_TRUE(fit);
        proposed += distanceMm(fit->pose, truth) / kTrials;
    }
    EXPECT_LT(proposed, 2.0);
}

TEST_F(JointFit, WeighsTargetsByTheirCovariance) {
    const Pose truth = test::curledPose(m_skeleton, 0.5);
    auto targets = targetsOf(truth);
    JointTarget& wrong = targets[static_cast<std::size_t>(m_skeleton.boneIndex("index_pip"))];
    wrong.pointInWorld += Vector3d(0, 0, 15);
    const auto fooled = core::fitPoseToJoints(m_skeleton, targets, m_skeleton.restPose());
    wrong.covariance = Vector3d(1, 1, 900).asDiagonal(); // one camera's depth: known to be unsure along z
    const auto weighted = core::fitPoseToJoints(m_skeleton, targets, m_skeleton.restPose());
    EXPECT_LT(distanceMm(weighted->pose, truth), 0.2 * distanceMm(fooled->pose, truth));
}

TEST_F(JointFit, StaysWithinLimitsUnlessToldNotTo) {
    const Pose truth = test::curledPose(m_skeleton, 1.9); // beyond 1.7
    const auto boxed = core::fitPoseToJoints(m_skeleton, targetsOf(truth), m_skeleton.restPose());
    ASSERT_TRUE(boxed);
    for (std::size_t d = 0; d < m_skeleton.dofs.size(); ++d) {
        const double angle = boxed->pose[core::kRigidDofs + static_cast<Eigen::Index>(d)];
        EXPECT_LE(angle, m_skeleton.dofs[d].maxRad + 1e-9);
        EXPECT_GE(angle, m_skeleton.dofs[d].minRad - 1e-9);
    }
    core::JointFitOptions free;
    free.withLimits = false;
    const auto unboxed = core::fitPoseToJoints(m_skeleton, targetsOf(truth), m_skeleton.restPose(), free);
    const int flexion = core::kRigidDofs; // of thumb_cmc: the first
    EXPECT_GT(unboxed->pose[flexion], m_skeleton.dofs[0].maxRad);
    EXPECT_LT(unboxed->rmsMm, boxed->rmsMm);
}

TEST_F(JointFit, NeedsThreeJointsThatAreNotOnALine) {
    const auto all = targetsOf(m_skeleton.restPose());
    EXPECT_FALSE(core::fitPoseToJoints(m_skeleton, {all[0], all[5]}, m_skeleton.restPose()));
    const auto finger = static_cast<std::size_t>(m_skeleton.boneIndex("middle_mcp"));
    EXPECT_FALSE(
        core::fitPoseToJoints(m_skeleton, {all[finger], all[finger + 1], all[finger + 2]}, m_skeleton.restPose()));
    EXPECT_TRUE(core::fitPoseToJoints(m_skeleton, {all[0], all[5], all[17]}, m_skeleton.restPose()));
}

} // namespace
