// SPDX-License-Identifier: MIT
#include "core/fitting/joint_problem.h"

#include <gtest/gtest.h>

#include "core/fitting/method_name.h"
#include "core/fitting/pose_estimator.h"
#include "tests/support/fitting_scene.h"

namespace {

core::KnownJoints jointsAt(const std::vector<core::HandModel>& hands, const core::HandPoses& poses, double sigmaMm) {
    core::KnownJoints known;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        auto& list = known.emplace_back();
        const auto joints = core::jointPositions(hands[h].skeleton, poses[h]);
        for (std::size_t b = 0; b < joints.size(); ++b)
            list.push_back({static_cast<int>(b), joints[b], sigmaMm * sigmaMm * Eigen::Matrix3d::Identity()});
    }
    return known;
}

TEST(KnownJoints, GradientIsHalfThatOfTheMisfitByFiniteDifferences) {
    const test::FittingScene scene("known gradient");
    const core::KnownJoints known = jointsAt(scene.hands, scene.truth, 0.7);
    for (std::size_t h = 0; h < 2; ++h) {
        const core::Skeleton& skeleton = scene.hands[h].skeleton;
        const auto equations = core::knownJointEquations(skeleton, known[h], scene.start[h]);
        constexpr double kWidth = 1e-6;
        for (Eigen::Index k = 0; k < skeleton.poseSize(); ++k) {
            const auto misfit = [&](double width) {
                const Eigen::VectorXd step = width * Eigen::VectorXd::Unit(skeleton.poseSize(), k);
                return core::knownJointMisfit({scene.hands[h]}, {known[h]}, {core::retract(scene.start[h], step)});
            };
            const double numeric = (misfit(kWidth) - misfit(-kWidth)) / (2 * kWidth);
            EXPECT_NEAR(equations.gradient[k], numeric / 2, 1e-4 * (1 + std::abs(numeric))) << k;
        }
        EXPECT_TRUE(equations.hessian.isApprox(equations.hessian.transpose()));
    }
}

TEST(KnownJoints, MisfitCountsSquaredDeviationsOfClickAndModel) {
    const test::FittingScene scene("known misfit");
    core::KnownJoints known = jointsAt(scene.hands, scene.truth, 2);
    EXPECT_NEAR(core::knownJointMisfit(scene.hands, known, scene.truth), 0, 1e-12);
    known[1][0].pointInWorld += Eigen::Vector3d(0, 3, 4);
    EXPECT_NEAR(core::knownJointMisfit(scene.hands, known, scene.truth), 25 / (2 * 2 + 1.0), 1e-9);
}

/// A single view does not tell how far away a hand is; its joints do.
TEST(KnownJoints, TellAFitWhatTheMasksLeaveOpen) {
    const test::FittingScene scene("known fit", 4);
    std::vector<cv::Mat> masks(4);
    masks[0] = scene.masks[0];
    const core::PoseEstimator estimator(scene.hands, scene.cameras);
    const core::Method method = core::parseMethod("best");
    const auto fit = [&](const core::KnownJoints& known) {
        return estimator.fit(masks, scene.start, method, {}, {}, 1, {.confidence = true}, known);
    };
    const auto without = fit({}), with = fit(jointsAt(scene.hands, scene.truth, 0.3));
    EXPECT_GT(scene.errorMm(without.poses), 2);
    EXPECT_LT(scene.errorMm(with.poses), 0.5 * scene.errorMm(without.poses));
    EXPECT_LT(scene.errorMm(with.poses), 1.5);
    ASSERT_TRUE(with.confidence && without.confidence);
    EXPECT_LT(with.confidence->jointCovarianceMm2[0][0].trace(), without.confidence->jointCovarianceMm2[0][0].trace());
}

} // namespace
