// SPDX-License-Identifier: MIT
#include "core/geometry/camera_ring.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace {

std::vector<Eigen::Vector3d> cornersOfABox() {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? 150 : -50, i & 2 ? 80 : -40, i & 4 ? 700 : 600);
    return points;
}

TEST(CameraRing, SeesEveryPointInsideTheMarginAndOneOfThemAtIt) {
    const std::vector<Eigen::Vector3d> points = cornersOfABox();
    const core::CameraRingOptions options;
    double leastMargin = 1e9;
    for (const core::Camera& camera : core::cameraRing(points)) {
        EXPECT_TRUE(core::isRotation(camera.cameraFromWorld.rotation, 1e-12));
        for (const Eigen::Vector3d& point : points) {
            const auto px = core::project(camera, point);
            ASSERT_TRUE(px);
            leastMargin = std::min({leastMargin, px->x(), px->y(), 1079 - px->x(), 1919 - px->y()});
        }
    }
    EXPECT_GE(leastMargin, options.marginPx);
    EXPECT_LT(leastMargin, options.marginPx + 4); // no farther away than needed
}

TEST(CameraRing, LooksAtTheMiddleUprightFromTwoHeights) {
    const std::vector<core::Camera> cameras = core::cameraRing(cornersOfABox());
    ASSERT_EQ(cameras.size(), 8u);
    const Eigen::Vector3d middle(50, 20, 650);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(cameras[i].name, "cam" + std::to_string(i));
        EXPECT_LT((*core::project(cameras[i], middle) - Eigen::Vector2d(539.5, 959.5)).norm(), 1e-9);
        EXPECT_GT(cameras[i].cameraFromWorld.rotation(1, 1), 0.5) << "down in the picture is down in the world";
        EXPECT_NEAR(cameras[i].cameraFromWorld.rotation(0, 1), 0, 1e-12) << "the horizon is level";
        EXPECT_EQ(cameras[i].centreInWorld().y() < middle.y(), i % 2 == 0) << "y points down";
        EXPECT_NEAR((cameras[i].centreInWorld() - middle).norm(), (cameras[0].centreInWorld() - middle).norm(), 1e-9);
    }
}

TEST(CameraRing, NeedsCamerasAndPoints) {
    core::CameraRingOptions none;
    none.count = 0;
    EXPECT_THROW(core::cameraRing({}), core::Error);
    EXPECT_THROW(core::cameraRing(cornersOfABox(), none), core::Error);
}

} // namespace
