// SPDX-License-Identifier: MIT
#include "widgets/views/scene/orbit_camera.h"

#include <cmath>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace {

using widgets::OrbitCamera;

constexpr int kHeight = 500;

/// Pixel offset of a point from the window's middle, y down: an independent pinhole.
QPointF seen(const OrbitCamera& camera, const Eigen::Vector3d& point) {
    const Eigen::Vector3d forward = -camera.away, right = forward.cross(camera.up).normalized();
    const Eigen::Vector3d down = forward.cross(right);
    const Eigen::Vector3d p = point - camera.eye();
    const double f = kHeight / 2.0 / std::tan(OrbitCamera::kViewAngleDeg * M_PI / 360);
    return {f * p.dot(right) / p.dot(forward), f * p.dot(down) / p.dot(forward)};
}

OrbitCamera makeCamera() {
    OrbitCamera camera;
    camera.focus = {10, -20, 600};
    camera.away = Eigen::Vector3d(0.3, -0.4, -0.8).normalized();
    camera.distanceMm = 700;
    return camera;
}

TEST(OrbitCamera, OrbitsAroundTheFocusWithALevelHorizon) {
    OrbitCamera camera = makeCamera();
    camera.orbit({37, -21}, kHeight);
    EXPECT_NEAR((camera.eye() - camera.focus).norm(), 700, 1e-9);
    EXPECT_EQ(camera.focus, makeCamera().focus);
    EXPECT_NEAR(camera.right().dot(camera.up), 0, 1e-12);
    // Dragging to the right turns the scene to the right: what is in front of the focus moves right.
    OrbitCamera turned = makeCamera();
    const Eigen::Vector3d inFront = turned.focus + 100 * turned.away;
    turned.orbit({30, 0}, kHeight);
    EXPECT_GT(seen(turned, inFront).x(), 5);
    OrbitCamera tilted = makeCamera();
    tilted.orbit({0, 30}, kHeight);
    EXPECT_GT(seen(tilted, inFront).y(), 5);
}

TEST(OrbitCamera, NeverTipsOver) {
    OrbitCamera camera = makeCamera();
    for (int i = 0; i < 100; ++i)
        camera.orbit({3, 100}, kHeight);
    EXPECT_LT(std::abs(camera.away.dot(camera.up)), 1 - 1e-4);
    EXPECT_TRUE(camera.right().allFinite());
}

TEST(OrbitCamera, PanningMovesTheFocusWithThePointer) {
    OrbitCamera camera = makeCamera();
    const Eigen::Vector3d focus = camera.focus;
    camera.pan({40, -25}, kHeight);
    EXPECT_NEAR(seen(camera, focus).x(), 40, 1e-9);
    EXPECT_NEAR(seen(camera, focus).y(), -25, 1e-9);
}

TEST(OrbitCamera, ZoomKeepsWhatIsUnderThePointer) {
    OrbitCamera camera = makeCamera();
    const Eigen::Vector3d down = (-camera.away).cross(camera.right());
    const Eigen::Vector3d point = camera.focus + 60 * camera.right() + 35 * down;
    const QPointF before = seen(camera, point);
    camera.zoom(1.7, before, kHeight);
    EXPECT_NEAR(camera.distanceMm, 700 / 1.7, 1e-9);
    EXPECT_NEAR(seen(camera, point).x(), before.x(), 1e-9);
    EXPECT_NEAR(seen(camera, point).y(), before.y(), 1e-9);
}

TEST(OrbitCamera, AFramedBallFitsTheWindow) {
    for (const QSize window : {QSize(800, 500), QSize(300, 500)}) {
        OrbitCamera camera = makeCamera();
        camera.frame({0, 0, 0}, 120, window);
        // The ball's outline is seen at asin(r / d) from the middle.
        const double angle = std::asin(120 / camera.distanceMm);
        const double f = window.height() / 2.0 / std::tan(OrbitCamera::kViewAngleDeg * M_PI / 360);
        EXPECT_NEAR(f * std::tan(angle), std::min(window.width(), window.height()) / 2.0, 0.5);
    }
}

TEST(OrbitCamera, StandsWhereItIsTold) {
    OrbitCamera camera = makeCamera();
    const Eigen::Vector3d eye(300, -100, 100);
    camera.standAt(eye);
    EXPECT_LT((camera.eye() - eye).norm(), 1e-9);
    const OrbitCamera before = camera;
    camera.standAt(camera.focus + 50 * camera.up); // straight above: there is no level horizon
    EXPECT_EQ(camera.eye(), before.eye());
}

} // namespace
