// SPDX-License-Identifier: MIT
#include "core/demo_hand/contact.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/demo_hand/implicit_surface.h"

namespace {

using Eigen::Vector3d;

core::TriangleMesh ball(const Vector3d& centre, double radiusMm) {
    core::TriangleMesh mesh =
        core::polygonise([&](const Vector3d& p) { return p.norm() - radiusMm; },
                         {Vector3d::Constant(-radiusMm - 2), Vector3d::Constant(radiusMm + 2)}, 0.5, Vector3d::Zero());
    for (Vector3d& vertex : mesh.vertices)
        vertex += centre;
    return mesh;
}

double gap(const Vector3d& direction, const core::TriangleMesh& a, const core::TriangleMesh& b) {
    return core::gapAlong(direction.normalized(), a.vertices, a.triangles, b.vertices, b.triangles, 0.5);
}

TEST(GapAlong, BetweenTwoBallsInLine) {
    const core::TriangleMesh a = ball({0, 0, 0}, 10);
    EXPECT_NEAR(gap({1, 0, 0}, a, ball({30, 0, 0}, 8)), 12, 0.1);
    EXPECT_NEAR(gap({0, 1, 0}, a, ball({0, 15, 0}, 8)), -3, 0.1);
    EXPECT_NEAR(gap({1, 1, 1}, a, ball(Vector3d(1, 1, 1).normalized() * 20, 8)), 2, 0.1);
}

TEST(GapAlong, OffCentreBallsMeetLater) {
    // Centres 12 apart across the direction: they touch when sqrt(d^2 + 12^2) = 18.
    const double expected = 30 - std::sqrt(18.0 * 18 - 12 * 12);
    EXPECT_NEAR(gap({1, 0, 0}, ball({0, 0, 0}, 10), ball({30, 12, 0}, 8)), expected, 0.15);
}

TEST(GapAlong, InfiniteIfTheyPassEachOther) {
    EXPECT_TRUE(std::isinf(gap({1, 0, 0}, ball({0, 0, 0}, 10), ball({30, 19, 0}, 8))));
}

} // namespace
