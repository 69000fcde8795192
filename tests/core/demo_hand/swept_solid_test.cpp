// SPDX-License-Identifier: MIT
#include "core/demo_hand/swept_solid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/clicks.h"

namespace {

using Eigen::Vector3d;

/// Along x from 0 to 20: 4 to the sides, 3 to the back, 2 to the palm, rounded ends of 5 and 6.
core::SweptSolid rod() {
    return core::SweptSolid({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}}, Vector3d::UnitZ(),
                            {{{0, 4, 3, 2}, {2, 4, 3, 2}}, 5, 6});
}

TEST(SweptSolid, TheSurfaceLiesAtTheSectionsHalfSizes) {
    const core::SweptSolid solid = rod();
    EXPECT_NEAR(solid.locate({7, 4, 0}).distanceMm, 0, 1e-9);
    EXPECT_NEAR(solid.locate({7, -4, 0}).distanceMm, 0, 1e-9);
    EXPECT_NEAR(solid.locate({7, 0, 3}).distanceMm, 0, 1e-9);
    EXPECT_NEAR(solid.locate({7, 0, -2}).distanceMm, 0, 1e-9);
    EXPECT_NEAR(solid.locate({7, 0, 5}).distanceMm, 2, 1e-9);
    EXPECT_NEAR(solid.locate({7, 2, 0}).distanceMm, -2, 1e-9);
}

TEST(SweptSolid, EndsInItsCaps) {
    const core::SweptSolid solid = rod();
    EXPECT_NEAR(solid.locate({-5, 0, 0}).distanceMm, 0, 1e-9);
    EXPECT_NEAR(solid.locate({26, 0, 0}).distanceMm, 0, 1e-9);
    EXPECT_LT(solid.locate({25, 0, 0}).distanceMm, 0);
    EXPECT_GT(solid.locate({-6, 0, 0}).distanceMm, 0);
}

TEST(SweptSolid, TellsThePlaceAlongThePath) {
    const core::SweptSolid solid = rod();
    EXPECT_NEAR(solid.locate({5, 1, 1}).at, 0.5, 0.03);
    EXPECT_NEAR(solid.locate({15, -3, 1}).at, 1.5, 0.03);
    EXPECT_NEAR(solid.locate({40, 0, 0}).at, 2, 1e-9);
}

TEST(SweptSolid, FarAwayItNeverClaimsMoreThanTheDistance) {
    const core::SweptSolid solid = rod();
    const double claimed = solid.locate({10, 200, 0}).distanceMm;
    EXPECT_GT(claimed, 100);
    EXPECT_LE(claimed, 196);
}

TEST(SweptSolid, WhatIsFarIsToldApartWithoutItsExactDistance) {
    const core::SweptSolid bent({{0, 0, 0}, {14, 9, 0}, {20, 25, 4}}, Vector3d::UnitZ(),
                                {{{0, 4, 3, 2}, {2, 7, 5, 6}}, 5, 6});
    auto random = test::randomFor("SweptSolid");
    std::uniform_real_distribution<double> place(-40, 60), limit(-3, 20);
    int near = 0, far = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vector3d point(place(random), place(random), place(random));
        const double farMm = limit(random);
        const double exact = bent.locate(point).distanceMm;
        const double told = bent.distanceMm(point, farMm);
        if (exact < farMm)
            EXPECT_EQ(told, exact) << point.transpose();
        else
            EXPECT_GE(told, farMm) << point.transpose();
        ++(exact < farMm ? near : far);
    }
    EXPECT_GT(near, 500);
    EXPECT_GT(far, 1000);
}

} // namespace
