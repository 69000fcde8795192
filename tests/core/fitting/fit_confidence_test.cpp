// SPDX-License-Identifier: MIT
#include "core/fitting/fit_confidence.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"
#include "tests/support/fitting_scene.h"

namespace {

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& generator) {
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

TEST(FitConfidence, PoseCovarianceIsThatOfTheEstimate) {
    // Monte Carlo: angles change by s times a draw of C, every measurement is repeated k times with the same noise.
    std::mt19937 generator(5);
    constexpr int kAngles = 3, kSize = core::kRigidDofs + kAngles, kRows = 24, kRepeats = 4, kRuns = 20000;
    constexpr double kSigma = 0.7, kScale = 1.4;
    const Eigen::MatrixXd jacobian = randomMatrix(kRows, kSize, generator);
    const Eigen::MatrixXd half = 0.2 * randomMatrix(kAngles, kAngles, generator);
    const Eigen::MatrixXd changes = half * half.transpose() + 0.01 * Eigen::MatrixXd::Identity(kAngles, kAngles);
    const Eigen::MatrixXd precision = changes.inverse();
    const Eigen::MatrixXd root = changes.llt().matrixL();
    const Eigen::MatrixXd hessian = kRepeats * jacobian.transpose() * jacobian;
    const Eigen::MatrixXd covariance = core::poseCovariance(hessian, kSigma, kRepeats, precision, kScale);

    Eigen::MatrixXd information = jacobian.transpose() * jacobian / (kSigma * kSigma);
    information.bottomRightCorner(kAngles, kAngles) += precision / (kScale * kScale);
    const Eigen::LDLT<Eigen::MatrixXd> solver(information);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(kSize, kSize);
    for (int run = 0; run < kRuns; ++run) {
        Eigen::VectorXd truth = Eigen::VectorXd::Zero(kSize);
        truth.tail(kAngles) = kScale * root * randomMatrix(kAngles, 1, generator);
        const Eigen::VectorXd measured = jacobian * truth + kSigma * randomMatrix(kRows, 1, generator);
        const Eigen::VectorXd error = solver.solve(jacobian.transpose() * measured / (kSigma * kSigma)) - truth;
        sum += error * error.transpose();
    }
    sum /= kRuns;
    for (int i = 0; i < kSize; ++i)
        EXPECT_NEAR(covariance(i, i), sum(i, i), 0.05 * sum(i, i)) << i;
    EXPECT_LT((covariance - sum).norm(), 0.05 * sum.norm());
}

TEST(FitConfidence, JointCovariancesAreThoseOfSteppedJoints) {
    const test::FittingScene scene("joint covariances", 2);
    const core::Skeleton& skeleton = scene.hands[0].skeleton;
    const core::Pose& pose = scene.truth[0];
    std::mt19937 generator(7);
    const Eigen::MatrixXd half = 0.004 * randomMatrix(pose.size(), pose.size(), generator);
    const auto predicted = core::jointCovariances(skeleton, pose, half * half.transpose());
    const auto at = core::jointPositions(skeleton, pose);
    std::vector<Eigen::Matrix3d> sum(at.size(), Eigen::Matrix3d::Zero());
    constexpr int kRuns = 20000;
    for (int run = 0; run < kRuns; ++run) {
        const auto moved =
            core::jointPositions(skeleton, core::retract(pose, half * randomMatrix(pose.size(), 1, generator)));
        for (std::size_t j = 0; j < at.size(); ++j)
            sum[j] += (moved[j] - at[j]) * (moved[j] - at[j]).transpose() / kRuns;
    }
    for (std::size_t j = 0; j < at.size(); ++j)
        EXPECT_LT((predicted[j] - sum[j]).norm(), 0.06 * sum[j].norm()) << j;
}

TEST(FitConfidence, DoubtsAPoseThatLeavesTheSilhouettesUnexplained) {
    test::FittingScene scene("doubt", 5);
    const core::PoseEstimator estimator(scene.hands, scene.cameras);
    const core::FitResult good =
        estimator.fit(scene.masks, scene.start, core::parseMethod("best"), {}, {}, 1, {.confidence = true});
    ASSERT_LT(scene.errorMm(good.poses), 0.8);
    ASSERT_TRUE(good.confidence);
    EXPECT_LT(good.confidence->doubt, core::kTrustedDoubt);
    EXPECT_GT(good.confidence->overlap, 0.9);

    core::FitProfile profile;
    const core::FittingHands hands = core::makeFittingHands(scene.hands);
    const std::vector<core::CameraTarget> targets = core::makeFitTargets(scene.cameras, scene.masks, {}, 1);
    core::PoseRefiner refiner(hands, scene.cameras, targets, scene.start, 1, profile);
    core::HandPoses bent = scene.truth;
    for (core::Pose& pose : bent)
        pose.tail(pose.size() - core::kRigidDofs).array() += 0.8;
    const core::FitConfidence bad = core::judgeFit(refiner, scene.start, bent, 0);
    EXPECT_GT(bad.doubt, core::kTrustedDoubt);
    EXPECT_GT(bad.deepPx, 10 * good.confidence->deepPx);
    EXPECT_LT(bad.overlap, good.confidence->overlap);
}

TEST(FitConfidence, DoubtsSilhouettesThatOverlapTooLittleForTheirNoise) {
    core::FitConfidence confidence; // nothing else speaks against the pose
    confidence.overlap = 0.95;
    const double same = core::doubtOf(confidence);
    confidence.overlap = 0.82;
    EXPECT_EQ(core::doubtOf(confidence), same) << "as noise alone does";
    confidence.overlap = 0.65;
    EXPECT_LT(same, core::kTrustedDoubt);
    EXPECT_GT(core::doubtOf(confidence), core::kTrustedDoubt) << "as a hand of another size does";
}

/// The same hand, larger: its poses are the same.
core::HandModel scaled(core::HandModel hand, double factor) {
    for (Eigen::Vector3d& vertex : hand.mesh.vertices)
        vertex *= factor;
    for (core::Bone& bone : hand.skeleton.bones)
        bone.worldFromBoneAtRest.translation *= factor;
    hand.skeleton.centreAtRest *= factor;
    return hand;
}

core::FitConfidence confidenceOf(const std::vector<core::HandModel>& hands, const std::vector<core::Camera>& cameras,
                                 const test::FittingScene& scene) {
    const core::PoseEstimator estimator(hands, cameras);
    return *estimator.fit(scene.masks, scene.start, core::parseMethod("best"), {}, {}, 1, {.confidence = true})
                .confidence;
}

TEST(FitConfidence, TheSystematicPartOfTheRightHandsAndCamerasIsSmall) {
    const test::FittingScene scene("systematic", 6);
    const core::FitConfidence own = confidenceOf(scene.hands, scene.cameras, scene);
    EXPECT_NEAR(own.systematic.scale, 1, 0.01);
    EXPECT_LT(std::abs(own.systematic.girthMm), 0.4);
    EXPECT_LT(own.systematic.shiftPx, 0.5);
    EXPECT_LT(own.systematic.jointMm, 0.6);
    EXPECT_LT(own.doubt, core::kTrustedDoubt);
}

TEST(FitConfidence, NoticesThatThePersonsHandsAreLarger) {
    const test::FittingScene scene("systematic", 6);
    const core::FitConfidence own = confidenceOf(scene.hands, scene.cameras, scene);
    const core::FitConfidence small =
        confidenceOf({scaled(scene.hands[0], 1 / 1.06), scaled(scene.hands[1], 1 / 1.06)}, scene.cameras, scene);
    EXPECT_GT(small.systematic.scale, 1.025);
    EXPECT_LT(small.systematic.scale, 1.09);
    EXPECT_GT(small.systematic.jointMm, 2 * own.systematic.jointMm);
    EXPECT_GT(small.doubt, own.doubt);
}

TEST(FitConfidence, NoticesPicturesThatAreShifted) {
    const test::FittingScene scene("systematic", 6);
    std::vector<core::Camera> moved = scene.cameras;
    for (std::size_t c = 0; c < moved.size(); ++c) {
        moved[c].intrinsics(0, 2) += c % 2 == 0 ? 4 : -4;
        moved[c].intrinsics(1, 2) += c % 3 == 0 ? 4 : -4;
    }
    const core::FitConfidence shifted = confidenceOf(scene.hands, moved, scene);
    EXPECT_GT(shifted.systematic.shiftPx, 2);
    EXPECT_LT(shifted.systematic.shiftPx, 8);
}

TEST(FitConfidence, DoubtsWhatAnotherHandOrAnotherCalibrationWouldMove) {
    core::FitConfidence confidence;
    confidence.overlap = 0.95;
    const double same = core::doubtOf(confidence);
    confidence.systematic.jointMm = 0.8;
    EXPECT_EQ(core::doubtOf(confidence), same) << "as measured hands do";
    confidence.systematic.jointMm = 1.7;
    EXPECT_GT(core::doubtOf(confidence), core::kTrustedDoubt);
}

TEST(FitConfidence, TheRealTimeVariantAndEmptyMasksHaveNone) {
    test::FittingScene scene("doubt", 5);
    const core::PoseEstimator estimator(scene.hands, scene.cameras);
    EXPECT_FALSE(
        estimator.fit(scene.masks, scene.start, core::parseMethod("best:live=1"), {}, {}, 1, {.confidence = true})
            .confidence);
    const std::vector<cv::Mat> none(scene.masks.size());
    EXPECT_FALSE(
        estimator.fit(none, scene.start, core::parseMethod("best"), {}, {}, 1, {.confidence = true}).confidence);
}

} // namespace
