// SPDX-License-Identifier: MIT
#include "core/geometry/epipolar_curve.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(EpipolarCurve, PassesThroughTheProjectionOfEveryPointOfTheRay) {
    const auto cameras = test::cameraRing(8);
    const Vector2d click(300, 1400); // off centre, so that the lens bends
    const auto ray = core::viewingRay(cameras[0], click);
    ASSERT_TRUE(ray);
    for (int other = 1; other < 8; ++other) {
        const core::Polyline curve = core::epipolarCurve(cameras[0], click, cameras[other]);
        int checked = 0;
        for (double depth = 300; depth < 3000; depth += 37) {
            const auto px = core::project(cameras[other], cameras[0].centreInWorld() + depth * ray->direction);
            if (!px || !core::isInside(cameras[other].size, *px))
                continue;
            const auto nearest = core::nearestOnPolyline(curve, *px);
            ASSERT_TRUE(nearest);
            EXPECT_LT((*nearest - *px).norm(), 0.05) << "camera " << other << " depth " << depth;
            ++checked;
        }
        EXPECT_GT(checked, 3);
    }
}

TEST(EpipolarCurve, IsBentByTheLens) {
    const auto cameras = test::cameraRing(8);
    const core::Polyline curve = core::epipolarCurve(cameras[0], {300, 1400}, cameras[2]);
    ASSERT_GT(curve.size(), 10u);
    const Vector2d chord = (curve.back() - curve.front()).normalized();
    double sag = 0;
    for (const Vector2d& p : curve) {
        const Vector2d d = p - curve.front();
        sag = std::max(sag, std::abs(d.x() * chord.y() - d.y() * chord.x()));
    }
    EXPECT_GT(sag, 2.0);
}

TEST(EpipolarCurve, MayBeVertical) {
    core::Camera low;
    low.size = {640, 480};
    low.intrinsics << 500, 0, 320, 0, 500, 240, 0, 0, 1;
    core::Camera high = low;
    high.cameraFromWorld.translation = Vector3d(0, 200, 0); // the second one stands 200 mm above
    const core::Polyline curve = core::epipolarCurve(low, {320, 240}, high);
    ASSERT_GT(curve.size(), 10u);
    for (const Vector2d& p : curve)
        EXPECT_NEAR(p.x(), 320, 1e-9);
    EXPECT_NEAR(curve.front().y(), 479.5, 1e-6); // cut at the lower border
    EXPECT_NEAR(curve.back().y(), 240, 0.1);     // towards infinity
}

TEST(EpipolarCurve, StaysInsideTheImageAndIsCutAtItsBorder) {
    const auto cameras = test::cameraRing(8);
    const core::Polyline curve = core::epipolarCurve(cameras[0], {541, 955}, cameras[3]);
    ASSERT_GE(curve.size(), 2u);
    for (const Vector2d& p : curve) {
        EXPECT_GE(p.x(), -0.5 - 1e-9);
        EXPECT_GE(p.y(), -0.5 - 1e-9);
        EXPECT_LE(p.x(), 1079.5 + 1e-9);
        EXPECT_LE(p.y(), 1919.5 + 1e-9);
    }
    const auto atBorder = [](const Vector2d& p) {
        return std::min({p.x() + 0.5, p.y() + 0.5, 1079.5 - p.x(), 1919.5 - p.y()}) < 1e-6;
    };
    EXPECT_TRUE(atBorder(curve.front()) || atBorder(curve.back()));
}

TEST(EpipolarCurve, IsEmptyWhereNothingIsSeen) {
    const auto cameras = test::cameraRing(8);
    EXPECT_TRUE(core::epipolarCurve(cameras[0], {500, 900}, cameras[0]).empty());
    core::Camera away = cameras[1];
    away.cameraFromWorld.rotation = Vector3d(-1, 1, -1).asDiagonal() * away.cameraFromWorld.rotation;
    away.cameraFromWorld.translation = -(away.cameraFromWorld.rotation * cameras[1].centreInWorld());
    EXPECT_TRUE(core::epipolarCurve(cameras[0], {500, 900}, away).empty());
}

TEST(NearestOnPolyline, ProjectsOntoSegmentsAndClampsAtTheEnds) {
    const core::Polyline line{{0, 0}, {10, 0}, {10, 10}};
    EXPECT_EQ(*core::nearestOnPolyline(line, {4, 3}), Vector2d(4, 0));
    EXPECT_EQ(*core::nearestOnPolyline(line, {12, 7}), Vector2d(10, 7));
    EXPECT_EQ(*core::nearestOnPolyline(line, {-5, -5}), Vector2d(0, 0));
    EXPECT_FALSE(core::nearestOnPolyline({{1, 1}}, {0, 0}));
}

} // namespace
