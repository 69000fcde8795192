// SPDX-License-Identifier: MIT
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/contour/rasteriser.h"
#include "tests/support/camera_ring.h"
#include "tests/support/shapes/ball.h"

namespace {

using namespace core;

TEST(DepthWindow, HoldsExactlyThePixelsOfTheWholeImage) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-350, 350);
    for (int trial = 0; trial < 12; ++trial) {
        Camera camera = test::cameraRing(8)[static_cast<std::size_t>(trial % 8)];
        camera = cropped(camera, {0, 0}, {270, 480}, 0.25);
        const test::Ball one = test::makeBall({place(random), place(random), place(random)}, 90);
        const test::Ball two = test::makeBall({place(random), place(random), place(random)}, 60);
        const std::vector<PosedSurface> surfaces{{&one.vertices, &one.triangles}, {&two.vertices, &two.triangles}};
        const DepthImage whole = renderDepth(camera, surfaces);
        const DepthWindow part = renderDepthWindow(camera, surfaces);
        const cv::Mat covered = whole.triangle >= 0;
        cv::Mat outside = covered.clone();
        outside(part.window).setTo(0);
        EXPECT_EQ(cv::countNonZero(outside), 0) << "nothing is drawn beyond the window";
        EXPECT_GT(cv::countNonZero(covered), 100);
        EXPECT_EQ(cv::countNonZero(whole.triangle(part.window) != part.image.triangle), 0);
        EXPECT_EQ(cv::countNonZero(whole.depthMm(part.window) != part.image.depthMm), 0);
        EXPECT_EQ(cv::countNonZero(renderMask(camera, surfaces) != covered), 0);
    }
}

TEST(DepthWindow, IsEmptyWhereNothingIsSeen) {
    const Camera camera = test::cameraRing(1)[0];
    const test::Ball behind = test::makeBall(1.8 * camera.centreInWorld(), 50);
    EXPECT_TRUE(renderDepthWindow(camera, {{&behind.vertices, &behind.triangles}}).window.empty());
    EXPECT_TRUE(renderDepthWindow(camera, {}).window.empty());
}

} // namespace
