// SPDX-License-Identifier: MIT
#include "core/simulation/simulated_world.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "core/simulation/forearm_surface.h"
#include "tests/support/camera_ring.h"
#include "tests/support/tiny_hands.h"

namespace core {
namespace {

TEST(ContourNoise, MovesAnOutlineAcrossItselfByItsDeviation) {
    cv::Mat disc = cv::Mat::zeros(700, 700, CV_8U);
    constexpr double kRadius = 250;
    for (int y = 0; y < disc.rows; ++y)
        for (int x = 0; x < disc.cols; ++x)
            disc.at<uchar>(y, x) = std::hypot(x - 350, y - 350) < kRadius ? 255 : 0;
    for (const double sigma : {0.75, 1.0}) {
        const cv::Mat noisy = withContourNoise(disc, sigma, 3);
        double sum = 0;
        constexpr int kRays = 2000;
        for (int k = 0; k < kRays; ++k) {
            const double angle = 2 * std::numbers::pi * k / kRays;
            double radius = kRadius + 20;
            while (noisy.at<uchar>(cv::Point(static_cast<int>(std::lround(350 + radius * std::cos(angle))),
                                             static_cast<int>(std::lround(350 + radius * std::sin(angle))))) == 0)
                radius -= 0.1;
            sum += (radius - kRadius) * (radius - kRadius);
        }
        const double pixels = 1.0 / 12; // of a boundary between whole pixels
        EXPECT_NEAR(std::sqrt(sum / kRays - pixels), sigma, 0.25 * sigma);
        EXPECT_EQ(cv::countNonZero(noisy != withContourNoise(disc, sigma, 3)), 0) << "the same for a seed";
        EXPECT_GT(cv::countNonZero(noisy != withContourNoise(disc, sigma, 4)), 0);
    }
}

TEST(ContourNoise, KeepsItsWigglesWhileTheyGrow) {
    cv::Mat square = cv::Mat::zeros(400, 300, CV_8U);
    square(cv::Rect(60, 80, 170, 240)).setTo(255);
    const ContourNoise noise(square, 1.5, 8);
    cv::Mat before = square.clone();
    int moved = 0;
    for (const double sigma : {0.25, 0.5, 1.0, 1.5}) {
        const cv::Mat changed = noise.applied(sigma) != square;
        const cv::Mat changedBefore = before != square;
        EXPECT_GT(cv::countNonZero(changed), moved) << "pixels, at " << sigma << " px";
        // Corners that the soft edge cuts off come back where the noise pushes outward: next to nothing.
        EXPECT_LT(cv::countNonZero(changedBefore & ~changed), 8) << "nothing moves back, at " << sigma << " px";
        moved = cv::countNonZero(changed);
        before = noise.applied(sigma);
    }
    EXPECT_EQ(cv::countNonZero(before != withContourNoise(square, 1.5, 8)), 0) << "the same draw at the most";
    EXPECT_EQ(cv::countNonZero(ContourNoise(cv::Mat::zeros(20, 30, CV_8U), 1, 1).applied(1)), 0);
}

TEST(PerturbedCameras, AreOffByNormalNumbersOfThatSize) {
    const std::vector<Camera> cameras = test::cameraRing(400);
    const RigError error{0.08, 0.7, 0.001};
    const std::vector<Camera> moved = perturbedCameras(cameras, error, 5);
    double turn = 0, shift = 0, focal = 0;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        const RigidMotion change = moved[c].cameraFromWorld * inverse(cameras[c].cameraFromWorld);
        turn += rotationLog(change.rotation).squaredNorm() / 3;
        shift += change.translation.squaredNorm() / 3;
        focal += std::pow(moved[c].intrinsics(0, 0) / cameras[c].intrinsics(0, 0) - 1, 2);
    }
    EXPECT_NEAR(std::sqrt(turn / 400) * 180 / std::numbers::pi, error.turnDeg, 0.1 * error.turnDeg);
    EXPECT_NEAR(std::sqrt(shift / 400), error.shiftMm, 0.1 * error.shiftMm);
    EXPECT_NEAR(std::sqrt(focal / 400), error.focalShare, 0.1 * error.focalShare);
}

TEST(OtherHands, AreLargerAndTheirPosesAreTheModels) {
    const std::vector<HandModel> hands = test::tinyHands();
    Imperfection imperfection;
    imperfection.scale = 1.03;
    const SimulatedWorld world = simulatedWorld(hands, test::cameraRing(2), imperfection, 1);
    const HandPoses poses = test::tinyMotion(3)[2];
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const auto model = jointPositions(hands[h].skeleton, poses[h]);
        const auto other = jointPositions(world.hands[h].skeleton, poses[h]);
        EXPECT_NEAR((other[1] - other[0]).norm(), 1.03 * (model[1] - model[0]).norm(), 1e-9);
        EXPECT_NEAR(signedVolume(world.hands[h].mesh), std::pow(1.03, 3) * signedVolume(hands[h].mesh), 1e-3);
    }
}

TEST(ForearmSurface, IsAClosedTubeThatLeavesTheHandAwayFromItsFingers) {
    const HandModel hand = test::tinyHand(Side::Left);
    const ForearmSurface arm = forearmSurface(hand, hand.skeleton.restPose());
    const double frustum = std::numbers::pi * 260 / 3 * (25.0 * 25 + 25 * 38 + 38 * 38);
    EXPECT_NEAR(signedVolume({arm.verticesInWorld, arm.triangles}), frustum, 0.02 * frustum);
    for (const Eigen::Vector3d& vertex : arm.verticesInWorld)
        EXPECT_LE(vertex.z(), 1e-9) << "fingers point along z";
}

TEST(SimulatedMasks, OfAPerfectWorldAreTheRenderedOnes) {
    const std::vector<HandModel> hands = test::tinyHands();
    const SimulatedWorld world = simulatedWorld(hands, test::cameraRing(2), {}, 1);
    const HandPoses poses = test::tinyMotion(1)[0];
    const std::vector<cv::Mat> masks = simulatedMasks(world, poses, "a/0");
    for (std::size_t c = 0; c < 2; ++c)
        EXPECT_EQ(cv::countNonZero(masks[c] != renderHandsMask(world.cameras[c], hands, poses)), 0);
    SimulatedWorld withArms = world;
    withArms.forearm = true;
    EXPECT_GT(cv::countNonZero(simulatedMasks(withArms, poses, "a/0")[0]), cv::countNonZero(masks[0]));
}

} // namespace
} // namespace core
