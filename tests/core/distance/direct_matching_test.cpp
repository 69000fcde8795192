// SPDX-License-Identifier: MIT
#include "core/distance/direct_matching.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/distance/circular_distance.h"
#include "tests/core/distance/test_contours.h"

namespace core {
namespace {

/// Four points around the origin, each looking away from it.
OrientedContour cross() {
    const auto pi = static_cast<float>(std::numbers::pi);
    return {{10, 0, -10, 0}, {0, 10, 0, -10}, {0, pi / 2, pi, -pi / 2}};
}

TEST(DirectMatching, FindsThePointByHand) {
    EXPECT_EQ(nearestPoint(cross(), {6, 1})->index, 0);
    EXPECT_NEAR(nearestPoint(cross(), {6, 1})->distancePx, std::sqrt(17.0), 1e-12);
    EXPECT_EQ(nearestPoint(cross(), {0, 0})->index, 0) << "ties go to the smaller index";
    const OrientationBins bins(4, true);
    EXPECT_EQ(nearestPointInBin(cross(), bins, 2, {6, 1})->index, 2);
    EXPECT_FALSE(nearestPointInBin(cross(), OrientationBins(8, true), 1, {6, 1}));
}

TEST(DirectMatching, WeighsOrientationAgainstDistance) {
    const double up = -std::numbers::pi / 2;
    EXPECT_EQ(nearestOrientedPoint(cross(), {6, 1}, up, 0.5, true)->index, 0) << "distance decides";
    EXPECT_EQ(nearestOrientedPoint(cross(), {6, 1}, up, 25, true)->index, 3) << "orientation decides";
    const auto match = nearestOrientedPoint(cross(), {6, 1}, up, 25, true);
    EXPECT_NEAR(match->distancePx, std::sqrt(36.0 + 121.0), 1e-5);
    EXPECT_EQ(nearestOrientedPoint(cross(), {0, 6}, up, 25, false)->index, 1) << "down is up when unsigned";
}

TEST(DirectMatching, QuantisedApproachesContinuousWithManyBins) {
    const OrientedContour contour = testing::gridContour(testing::crossingHandsMask(150, 110));
    const OrientationBins bins(256, true);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector2d px(13.7 * i - 150 * std::floor(13.7 * i / 150), 0.55 * i);
        const double angle = -3 + 0.031 * i;
        const auto continuous = nearestOrientedPoint(contour, px, angle, 25, true);
        const auto quantised = nearestQuantisedPoint(contour, bins, px, bins.binOf(angle), 25);
        EXPECT_NEAR(continuous->distancePx, quantised->distancePx, 25 * bins.widthRad() + 1e-6);
    }
}

TEST(DirectMatching, HasNoAnswerWithoutPoints) {
    EXPECT_FALSE(nearestPoint({}, {0, 0}));
    EXPECT_FALSE(nearestOrientedPoint({}, {0, 0}, 0, 25, true));
    EXPECT_FALSE(nearestQuantisedPoint({}, OrientationBins(8, true), {0, 0}, 0, 25));
}

} // namespace
} // namespace core
