// SPDX-License-Identifier: MIT
#include "core/distance/orientation_bins.h"

#include <cmath>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

#include "core/distance/circular_distance.h"
#include "core/error.h"

namespace core {
namespace {

class BinsOfEveryKind : public ::testing::TestWithParam<std::tuple<int, bool, double>> {};

/// Oracle: the bin whose centre is nearest on the circle, found by trying all.
TEST_P(BinsOfEveryKind, BinIsTheOneWithTheNearestCentre) {
    const auto [count, isSigned, offset] = GetParam();
    const OrientationBins bins(count, isSigned, offset);
    for (double angle = -12.3456; angle < 12.4; angle += 0.0371) {
        const auto distance = [&](int bin) { return circularDistance(angle, bins.centreRad(bin), isSigned); };
        const auto [nearest, second] = bins.nearestTwo(angle);
        EXPECT_EQ(nearest, bins.binOf(angle));
        for (int other = 0; other < count; ++other) {
            EXPECT_LE(distance(nearest), distance(other) + 1e-9);
            if (other != nearest)
                EXPECT_LE(distance(second), distance(other) + 1e-9);
        }
        EXPECT_LE(distance(nearest), bins.widthRad() / 2 + 1e-9);
        EXPECT_TRUE(count == 1 || nearest != second);
    }
}

TEST_P(BinsOfEveryKind, DistanceOfBinsIsThatOfTheirCentres) {
    const auto [count, isSigned, offset] = GetParam();
    const OrientationBins bins(count, isSigned, offset);
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            EXPECT_NEAR(bins.distanceRad(a, b), circularDistance(bins.centreRad(a), bins.centreRad(b), isSigned), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(All, BinsOfEveryKind,
                         ::testing::Combine(::testing::Values(1, 2, 3, 4, 8, 15, 16), ::testing::Bool(),
                                            ::testing::Values(0.0, 0.5)));

TEST(OrientationBins, WidthsFollowTheSign) {
    EXPECT_NEAR(OrientationBins(16, true).widthRad() * 180 / std::numbers::pi, 22.5, 1e-12);
    EXPECT_NEAR(OrientationBins(16, false).widthRad() * 180 / std::numbers::pi, 11.25, 1e-12);
}

TEST(OrientationBins, OppositeDirectionsShareAnUnsignedBinOnly) {
    for (double angle = -3; angle < 3; angle += 0.17) {
        EXPECT_EQ(OrientationBins(8, false).binOf(angle), OrientationBins(8, false).binOf(angle + std::numbers::pi));
        EXPECT_NE(OrientationBins(8, true).binOf(angle), OrientationBins(8, true).binOf(angle + std::numbers::pi));
    }
}

TEST(OrientationBins, RefuseImpossibleCounts) {
    EXPECT_THROW(OrientationBins(0, true), Error);
    EXPECT_THROW(OrientationBins(257, true), Error);
    EXPECT_THROW(OrientationBins(8, true, 1.0), Error);
}

} // namespace
} // namespace core
