// SPDX-License-Identifier: MIT
#include "core/annotation/interpolation.h"

#include <gtest/gtest.h>

namespace {

using core::Interpolation;
using Eigen::Vector3d;

Vector3d parabola(double t) {
    return {1 + 2 * t - 0.5 * t * t, -3 + t, 0.25 * t * t};
}

TEST(Interpolation, LinearIsExactOnALine) {
    const std::map<int, Vector3d> points{{10, {0, 0, 0}}, {20, {10, -20, 5}}};
    const Vector3d expected(3, -6, 1.5);
    EXPECT_LT((*core::interpolated(points, 13, Interpolation::Linear) - expected).norm(), 1e-12);
    EXPECT_LT((*core::interpolated(points, 13, Interpolation::Cubic) - expected).norm(), 1e-12);
}

TEST(Interpolation, CubicIsExactOnAParabolaAlsoAtTheEndsAndWithUnevenFrames) {
    std::map<int, Vector3d> points;
    for (const int frame : {0, 3, 11, 12, 30})
        points[frame] = parabola(frame);
    for (int frame = 0; frame <= 30; ++frame)
        EXPECT_LT((*core::interpolated(points, frame, Interpolation::Cubic) - parabola(frame)).norm(), 1e-9) << frame;
}

TEST(Interpolation, CubicIsSmoothWhereLinearHasACorner) {
    const std::map<int, Vector3d> points{{0, {0, 0, 0}}, {100, {0, 50, 0}}, {200, {0, 0, 0}}};
    const double before = core::interpolated(points, 100, Interpolation::Cubic)->y() -
                          core::interpolated(points, 99, Interpolation::Cubic)->y();
    const double after = core::interpolated(points, 101, Interpolation::Cubic)->y() -
                         core::interpolated(points, 100, Interpolation::Cubic)->y();
    EXPECT_NEAR(before, after, 0.03);
}

TEST(Interpolation, NeverExtrapolates) {
    const std::map<int, Vector3d> points{{10, {1, 2, 3}}, {20, {4, 5, 6}}};
    EXPECT_FALSE(core::interpolated(points, 9, Interpolation::Cubic));
    EXPECT_FALSE(core::interpolated(points, 21, Interpolation::Linear));
    EXPECT_FALSE(core::interpolated({}, 0, Interpolation::Linear));
    EXPECT_EQ(*core::interpolated(points, 20, Interpolation::Linear), Vector3d(4, 5, 6));
}

} // namespace
