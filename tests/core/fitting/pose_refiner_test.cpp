// SPDX-License-Identifier: MIT
#include "core/fitting/pose_refiner.h"

#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/fitting_scene.h"

namespace {

using core::Detail;
using core::FitIteration;
using core::HandPoses;
using core::IterationSettings;
using core::kRigidDofs;
using core::PoseRefiner;

class Refiner : public testing::Test {
protected:
    explicit Refiner(int cameras = 4)
        : m_scene("pose refiner", cameras) {}

    void prepare() {
        m_hands = core::makeFittingHands(m_scene.hands);
        m_targets = core::makeFitTargets(m_scene.cameras, m_scene.masks, {}, 1);
    }
    void SetUp() override { prepare(); }

    PoseRefiner refiner(int threads = 1) {
        return PoseRefiner(m_hands, m_scene.cameras, m_targets, m_scene.start, threads, m_profile);
    }

    test::FittingScene m_scene;
    core::FittingHands m_hands;
    std::vector<core::CameraTarget> m_targets;
    core::FitProfile m_profile;
};

TEST_F(Refiner, LevelsOfTheHandsGrowFromCoarseToFull) {
    ASSERT_EQ(m_hands.levels.size(), 2u);
    for (std::size_t h = 0; h < 2; ++h) {
        EXPECT_LT(m_hands.levels[h][0].vertexCount(), m_hands.levels[h][1].vertexCount());
        EXPECT_LT(m_hands.levels[h][1].vertexCount(), m_hands.levels[h][2].vertexCount());
        EXPECT_EQ(m_hands.levels[h][2].vertexCount(), m_scene.hands[h].mesh.vertices.size());
    }
}

TEST_F(Refiner, FindsHowFarContoursAreOff) {
    EXPECT_LT(refiner().contourNoise(m_scene.truth).px, 0.75);
    for (cv::Mat& mask : m_scene.masks)
        cv::dilate(mask, mask, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}));
    prepare();
    PoseRefiner refining = refiner();
    const PoseRefiner::Noise noise = refining.contourNoise(m_scene.truth);
    EXPECT_NEAR(noise.px, 1.4826 * 3, 0.7) << "every contour point lies 3 px outside";
    EXPECT_EQ(noise.perCameraPx.size(), m_targets.size());
}

TEST_F(Refiner, FindsForearmsThatAFarStartDoesNotShowOnceHandsAreNear) {
    test::drawForearms(m_scene, m_scene.masks);
    prepare();
    HandPoses far = m_scene.truth;
    for (core::Pose& pose : far)
        pose.head<3>() += Eigen::Vector3d(0, 0, 300);
    PoseRefiner refining = refiner();
    EXPECT_FALSE(refining.updateForearms(m_scene.truth)) << "nobody asked for forearms to be cut";
    refining.cutForearms(far);
    EXPECT_FALSE(refining.forearms().any());
    EXPECT_TRUE(refining.updateForearms(m_scene.truth));
    EXPECT_TRUE(refining.forearms().all());
    refining.updateForearms(far);
    EXPECT_TRUE(refining.forearms().all()) << "what was found stays";
}

TEST_F(Refiner, RestsAtTheTruth) {
    for (const Detail detail : {Detail::Coarse, Detail::Medium, Detail::Full}) {
        IterationSettings settings;
        settings.detail = detail;
        HandPoses poses = m_scene.truth;
        PoseRefiner refining = refiner();
        const FitIteration record = refining.iterate(poses, settings);
        EXPECT_LT(record.costMm2, detail == Detail::Coarse ? 0.8 : 0.3) << "mm^2: pixels are about 1 mm wide";
        EXPECT_LT(record.stepMm, 1.0);
        EXPECT_LT(m_scene.errorMm(poses), 1.0);
    }
}

TEST_F(Refiner, EveryIterationBringsTheHandsNearer) {
    IterationSettings settings;
    HandPoses poses = m_scene.start;
    PoseRefiner refining = refiner();
    double error = m_scene.errorMm(poses), cost = std::numeric_limits<double>::infinity();
    ASSERT_GT(error, 6);
    for (int i = 0; i < 4; ++i) {
        const HandPoses before = poses;
        const FitIteration record = refining.iterate(poses, settings);
        EXPECT_LT(record.costMm2, cost);
        EXPECT_NEAR(record.stepMm, core::meanJointDistanceMm(m_scene.hands, before, poses), 1e-12);
        cost = record.costMm2;
    }
    EXPECT_LT(m_scene.errorMm(poses), 0.4 * error);
}

TEST_F(Refiner, RigidStepsMoveTheWholeHandOnly) {
    IterationSettings settings;
    settings.rigidOnly = true;
    HandPoses poses = m_scene.start;
    refiner().iterate(poses, settings);
    for (std::size_t h = 0; h < 2; ++h) {
        EXPECT_EQ(poses[h].tail(6), m_scene.start[h].tail(6));
        EXPECT_GT((poses[h].head(6) - m_scene.start[h].head(6)).norm(), 0.1);
    }
}

TEST_F(Refiner, DoesNotDependOnTheThreads) {
    IterationSettings settings;
    settings.contourPointsPerCamera = 100;
    HandPoses one = m_scene.start, two = m_scene.start;
    PoseRefiner single = refiner(1), pair = refiner(2);
    for (int i = 0; i < 3; ++i) {
        const FitIteration a = single.iterate(one, settings), b = pair.iterate(two, settings);
        EXPECT_EQ(a.costMm2, b.costMm2);
        EXPECT_EQ(a.matches, b.matches);
        for (std::size_t h = 0; h < 2; ++h)
            EXPECT_EQ(one[h], two[h]) << "bit by bit";
    }
    EXPECT_EQ(single.silhouetteDifferencePx(one), pair.silhouetteDifferencePx(two));
}

TEST_F(Refiner, WithoutMatchesNothingMoves) {
    IterationSettings settings;
    settings.rule.tauRad = 0;
    HandPoses poses = m_scene.start;
    const FitIteration record = refiner().iterate(poses, settings);
    EXPECT_EQ(record.matches, 0);
    EXPECT_GT(record.rejected, 400);
    EXPECT_EQ(record.costMm2, 0);
    EXPECT_EQ(record.stepMm, 0);
    for (std::size_t h = 0; h < 2; ++h)
        EXPECT_EQ(poses[h], m_scene.start[h]);
}

TEST_F(Refiner, EveryRimPointIsMatchedOrRejected) {
    IterationSettings settings;
    HandPoses poses = m_scene.start;
    const FitIteration all = refiner().iterate(poses, settings);
    EXPECT_EQ(all.rejected, 0);
    poses = m_scene.start;
    settings.rule.tauRad = 0.3f;
    const FitIteration some = refiner().iterate(poses, settings);
    EXPECT_GT(some.rejected, 20);
    EXPECT_EQ(some.matches + some.rejected, all.matches);
}

TEST_F(Refiner, ContourPointsPullAsWell) {
    IterationSettings settings;
    HandPoses poses = m_scene.start;
    const int rimOnly = refiner().iterate(poses, settings).matches;
    poses = m_scene.start;
    settings.contourPointsPerCamera = 120;
    EXPECT_EQ(refiner().iterate(poses, settings).matches, rimOnly + 4 * 120);
}

TEST_F(Refiner, AStrongPriorHoldsTheAnglesOfTheStart) {
    IterationSettings settings;
    settings.startPrior = 1e9;
    HandPoses poses = m_scene.start;
    PoseRefiner refining = refiner();
    for (int i = 0; i < 3; ++i)
        refining.iterate(poses, settings);
    for (std::size_t h = 0; h < 2; ++h) {
        EXPECT_LT((poses[h].tail(6) - m_scene.start[h].tail(6)).norm(), 1e-4);
        EXPECT_GT((poses[h].head(6) - m_scene.start[h].head(6)).norm(), 0.1);
    }
    poses = m_scene.truth; // and pulls them back to it from elsewhere
    refining.iterate(poses, settings);
    EXPECT_LT((poses[0].tail(6) - m_scene.start[0].tail(6)).norm(), 1e-3);
}

TEST_F(Refiner, AnglesStayWithinTheSlackOfTheirLimits) {
    constexpr double kSlackRad = 0.2;
    for (core::HandModel& hand : m_scene.hands) { // what the masks show needs angles far outside
        for (core::DegreeOfFreedom& dof : hand.skeleton.dofs) {
            dof.minRad = -0.05;
            dof.maxRad = 0.02;
        }
    }
    for (core::Pose& pose : m_scene.truth)
        pose.tail(6) << 0.5, 0.3, 0.7, -0.5, -0.3, 0.8;
    m_scene.masks = m_scene.seen(m_scene.truth);
    prepare();
    HandPoses poses = m_scene.truth;
    for (core::Pose& pose : poses)
        pose.tail(6).setZero();
    PoseRefiner refining = refiner();
    double farthest = 0;
    for (int i = 0; i < 8; ++i) {
        refining.iterate(poses, {});
        for (const core::Pose& pose : poses) {
            EXPECT_LE(pose.tail(6).maxCoeff(), 0.02 + kSlackRad + 1e-9);
            EXPECT_GE(pose.tail(6).minCoeff(), -0.05 - kSlackRad - 1e-9);
            farthest = std::max(farthest, pose.tail(6).maxCoeff());
        }
    }
    EXPECT_GT(farthest, 0.02) << "limits give way a little";
    poses[0][kRigidDofs] = 0.9; // recorded poses may start even farther outside: never pushed on, drawn back
    refining.iterate(poses, {});
    EXPECT_LE(poses[0][kRigidDofs], 0.9);
}

TEST_F(Refiner, RobustWeightsIgnoreWhatIsFarAway) {
    for (cv::Mat& mask : m_scene.masks) { // a hole in the palms that no hand has
        const cv::Rect bounds = core::maskBounds(mask);
        mask(cv::Rect(bounds.x + bounds.width / 3, bounds.y + bounds.height / 3, 26, 26)) = 0;
    }
    prepare();
    IterationSettings plain, robust;
    plain.contourPointsPerCamera = robust.contourPointsPerCamera = 200;
    robust.robustMm = 1.5;
    HandPoses fooled = m_scene.truth, firm = m_scene.truth;
    PoseRefiner refining = refiner();
    for (int i = 0; i < 5; ++i) {
        refining.iterate(fooled, plain);
        refining.iterate(firm, robust);
    }
    EXPECT_LT(m_scene.errorMm(firm), 0.6 * m_scene.errorMm(fooled));
}

TEST_F(Refiner, SilhouetteDifferenceGrowsWithTheDisplacement) {
    PoseRefiner refining = refiner();
    const double atTruth = refining.silhouetteDifferencePx(m_scene.truth);
    EXPECT_LT(atTruth, 0.8);
    double before = atTruth;
    for (const double mm : {3.0, 6.0, 12.0, 24.0}) {
        HandPoses poses = m_scene.truth;
        for (core::Pose& pose : poses)
            pose.head<3>() += mm * Eigen::Vector3d(0.6, 0.64, 0.48);
        const double difference = refining.silhouetteDifferencePx(poses);
        EXPECT_GT(difference, before);
        before = difference;
    }
    EXPECT_GT(before, 6) << "px: 24 mm are about 20 px, of which the outlines see the part across them";
}

TEST_F(Refiner, ReportsTheSecondsOfEachStep) {
    HandPoses poses = m_scene.start;
    PoseRefiner refining = refiner();
    refining.iterate(poses, {});
    refining.silhouetteDifferencePx(poses);
    for (const double seconds :
         {m_profile.skinning, m_profile.rims, m_profile.matching, m_profile.solving, m_profile.scoring}) {
        EXPECT_GT(seconds, 0);
        EXPECT_LT(seconds, 5);
    }
}

} // namespace
