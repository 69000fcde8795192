// SPDX-License-Identifier: MIT
#include "core/simulation/simulated_pictures.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "core/segmentation/background_difference.h"
#include "tests/support/camera_ring.h"
#include "tests/support/tiny_hands.h"

namespace core {
namespace {

Camera smallCamera() {
    return cropped(test::cameraRing(1)[0], {-0.5, -0.5}, {270, 480}, 0.25);
}

TEST(SensorNoise, HasTheDeviationOfItsBrightness) {
    const PictureOptions options{0.5, 5, 0.7, 3, 0.3};
    for (const int level : {40, 160}) {
        const cv::Mat grey(300, 300, CV_8UC3, cv::Scalar::all(level));
        cv::Scalar mean, deviation;
        cv::meanStdDev(withSensorNoise(grey, options, 1), mean, deviation);
        EXPECT_NEAR(mean[0], level, 0.2);
        EXPECT_NEAR(deviation[0], std::sqrt(9 + 0.09 * level + 1.0 / 12), 0.1) << "rounding adds a twelfth";
    }
}

TEST(SimulatedPicture, ShowsTheHandsWhereTheirSilhouetteIs) {
    const SimulatedWorld world = simulatedWorld(test::tinyHands(), {smallCamera()}, {}, 1);
    const Motion motion = test::tinyMotion(3);
    const PictureOptions still{0, 1, 0.5, 2, 0.2};
    const cv::Mat room = backgroundPicture(world.cameras[0], 1);
    const cv::Mat empty = withSensorNoise(room, still, 7);
    const cv::Mat mask = differenceMask(simulatedPicture(world, 0, motion, 1, room, still, "a/1"), empty);
    const cv::Mat truth = renderHandsMask(world.cameras[0], world.hands, motion[1]);
    const double both = cv::countNonZero(mask & truth), any = cv::countNonZero(mask | truth);
    EXPECT_GT(both / any, 0.8);
    EXPECT_EQ(cv::countNonZero(differenceMask(withSensorNoise(room, still, 8), empty)), 0)
        << "noise alone is not taken for a hand";
}

TEST(SimulatedPicture, IsBlurredByMotion) {
    const SimulatedWorld world = simulatedWorld(test::tinyHands(), {smallCamera()}, {}, 1);
    Motion motion = test::tinyMotion(1);
    motion.resize(3, motion[0]);
    for (std::size_t f = 0; f < 3; ++f)
        for (Pose& pose : motion[f])
            pose[1] += 40 * static_cast<double>(f);
    const cv::Mat black(480, 270, CV_8UC3, cv::Scalar::all(0));
    const PictureOptions still{0, 1, 0, 0, 0}, blurred{1, 15, 0, 0, 0};
    const auto lit = [&](const PictureOptions& options) {
        cv::Mat grey;
        cv::cvtColor(simulatedPicture(world, 0, motion, 1, black, options, "a"), grey, cv::COLOR_BGR2GRAY);
        return cv::countNonZero(grey > 4);
    };
    EXPECT_GT(lit(blurred), 1.1 * lit(still)) << "the hand is smeared over more pixels";
}

} // namespace
} // namespace core
