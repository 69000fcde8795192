// SPDX-License-Identifier: MIT
#include "core/distance/contour_index.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/distance/circular_distance.h"
#include "core/numeric/random.h"
#include "tests/core/distance/test_contours.h"

namespace core {
namespace {

/// Oracle: every point with |p - q| within the gate, cost from the definition; the least cost, or infinity.
template <typename Cost>
double leastCost(const OrientedContour& contour, float x, float y, double gatePx, const Cost& costOf) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const double d = std::hypot(x - contour.x[i], y - contour.y[i]);
        if (d <= gatePx)
            least = std::min(least, d + costOf(i));
    }
    return least;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class ContourIndexOf : public ::testing::TestWithParam<int> {
protected:
    /// A contour with holes; with points inside a parameter's orientation range removed, so that some bins are empty;
    /// scattered points.
    OrientedContour contour() const {
        if (GetParam() == 2)
            return testing::randomContour(60, 200, 150, 4);
        OrientedContour contour = orientedContour(testing::crossingHandsMask(200, 150));
        for (float& angle : contour.angleRad)
            angle = GetParam() == 1 ? std::abs(angle) : angle;
        return contour;
    }
};

TEST_P(ContourIndexOf, FindsTheSameCostsAsBruteForce) {
    const OrientedContour contour = this->contour();
    RandomGenerator random(11);
    for (const bool isSigned : {true, false}) {
        const OrientationBins bins(8, isSigned);
        const ContourIndex index(contour, bins);
        for (int trial = 0; trial < 400; ++trial) {
            const auto x = static_cast<float>(400 * random.uniform() - 100);
            const auto y = static_cast<float>(350 * random.uniform() - 100);
            const auto angle = static_cast<float>((2 * random.uniform() - 1) * std::numbers::pi);
            const float gate = trial % 3 == 0 ? std::numeric_limits<float>::infinity() : static_cast<float>(trial) / 8;
            const int bin = bins.binOf(angle);
            const auto expectCost = [&](const ContourMatch& match, const auto& costOf) {
                const double least = leastCost(contour, x, y, gate, costOf);
                ASSERT_EQ(match.index >= 0, least < kInfinity);
                if (match.index >= 0) {
                    ASSERT_NEAR(match.distance, least, 1e-3);
                    const auto i = static_cast<std::size_t>(match.index);
                    ASSERT_NEAR(std::hypot(x - contour.x[i], y - contour.y[i]) + costOf(i), least, 1e-3);
                }
            };
            expectCost(
                index.nearest(x, y, gate), [](std::size_t) { return 0.0; });
            expectCost(
                index.nearestInBin(x, y, bin, gate),
                [&](std::size_t i) { return bins.binOf(contour.angleRad[i]) == bin ? 0.0 : kInfinity; });
            expectCost(
                index.nearestWithin(x, y, angle, 0.4f, gate),
                [&](std::size_t i) {
                    return circularDistance(angle, contour.angleRad[i], isSigned) < 0.4f ? 0.0 : kInfinity;
                });
            expectCost(index.nearestDirectional(x, y, bin, 25, gate),
                       [&](std::size_t i) { return 25 * bins.distanceRad(bin, bins.binOf(contour.angleRad[i])); });
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Contours, ContourIndexOf, ::testing::Values(0, 1, 2));

TEST(ContourIndex, FindsNothingWithoutPoints) {
    const ContourIndex index({}, OrientationBins(8, true));
    EXPECT_EQ(index.nearest(3, 4, std::numeric_limits<float>::infinity()).index, -1);
    EXPECT_EQ(index.nearestDirectional(3, 4, 0, 25, 100).index, -1);
}

} // namespace
} // namespace core
