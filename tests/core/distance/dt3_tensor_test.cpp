// SPDX-License-Identifier: MIT
#include "core/distance/dt3_tensor.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/numeric/random.h"
#include "tests/core/distance/test_contours.h"

namespace core {
namespace {

using testing::crossingHandsMask;
using testing::gridContour;
using testing::randomContour;

/// Oracle: brute force over all points, orientations quantised. Compared by cost: equal costs may have several owners.
void expectExactTensor(const OrientedContour& contour, const OrientationBins& bins, double lambda,
                       const cv::Rect& region, int stride = 1) {
    const Dt3Tensor tensor = computeDt3Tensor(contour, bins, lambda, region);
    for (int y = region.y; y < region.br().y; y += stride) {
        for (int x = region.x; x < region.br().x; x += stride) {
            for (int bin = 0; bin < bins.count(); ++bin) {
                const double angle = bins.centreRad(bin);
                const auto match = nearestFromTensor(tensor, contour, Eigen::Vector2d(x, y), angle);
                const auto exact = nearestQuantisedPoint(contour, bins, Eigen::Vector2d(x, y), bin, lambda);
                ASSERT_TRUE(match && exact);
                ASSERT_NEAR(match->distancePx, exact->distancePx, 1e-3) << x << ", " << y << ", bin " << bin;
            }
        }
    }
}

TEST(Dt3Tensor, IsExactOnAContourWithHoles) {
    const OrientedContour contour = gridContour(crossingHandsMask(120, 90));
    expectExactTensor(contour, OrientationBins(16, true), 25, cv::Rect(0, 0, 120, 90), 3);
    expectExactTensor(contour, OrientationBins(16, false), 25, cv::Rect(0, 0, 120, 90), 3);
    expectExactTensor(contour, OrientationBins(5, true), 8, cv::Rect(0, 0, 120, 90), 4);
}

TEST(Dt3Tensor, RelaxesAroundTheWholeCircle) {
    RandomGenerator random(3);
    for (int count = 1; count <= 33; ++count) {
        const int only = static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
        const OrientationBins bins(count, true);
        OrientedContour contour = randomContour(1, 1, 1, 5);
        contour.x[0] = contour.y[0] = 4;
        contour.angleRad[0] = static_cast<float>(bins.centreRad(only)); // every other bin must hear of it both ways
        expectExactTensor(contour, bins, 2.5, cv::Rect(0, 0, 9, 7));
    }
}

TEST(Dt3Tensor, IsExactOnScatteredPointsWithEmptyBins) {
    for (std::uint64_t seed = 1; seed < 30; ++seed) {
        OrientedContour contour = randomContour(static_cast<int>(1 + seed), 20, 16, seed);
        for (std::size_t i = 0; i < contour.size(); ++i) { // all inside: points outside are another test's
            contour.x[i] = std::clamp(contour.x[i], 0.0F, 19.0F);
            contour.y[i] = std::clamp(contour.y[i], 0.0F, 15.0F);
        }
        expectExactTensor(contour, OrientationBins(16, seed % 2 == 0), 0.5 * static_cast<double>(seed),
                          cv::Rect(0, 0, 20, 16));
    }
}

TEST(Dt3Tensor, WithLambdaZeroIsThePlainTransform) {
    const OrientedContour contour = gridContour(crossingHandsMask(80, 60));
    const Dt3Tensor tensor = computeDt3Tensor(contour, OrientationBins(8, true), 0, cv::Rect(0, 0, 80, 60));
    for (int y = 0; y < 60; y += 2) {
        for (int x = 0; x < 80; x += 2) {
            const auto exact = nearestPoint(contour, Eigen::Vector2d(x, y));
            EXPECT_NEAR(nearestFromTensor(tensor, contour, Eigen::Vector2d(x, y), 1.1)->distancePx, exact->distancePx,
                        1e-6);
        }
    }
}

TEST(Dt3Tensor, SearchesEverythingOutsideItsRegion) {
    const OrientedContour contour = gridContour(crossingHandsMask(80, 60));
    const OrientationBins bins(16, true);
    const Dt3Tensor tensor = computeDt3Tensor(contour, bins, 25, cv::Rect(0, 0, 80, 60));
    for (const Eigen::Vector2d& px : {Eigen::Vector2d(-20, 30), Eigen::Vector2d(200, 59), Eigen::Vector2d(40, -0.6)}) {
        const auto exact = nearestQuantisedPoint(contour, bins, px, bins.binOf(0.4), 25);
        EXPECT_EQ(nearestFromTensor(tensor, contour, px, 0.4)->index, exact->index);
    }
}

TEST(Dt3Tensor, HasNoAnswerWithoutPointsAndRefusesTooMany) {
    const OrientationBins bins(8, true);
    const Dt3Tensor tensor = computeDt3Tensor({}, bins, 25, cv::Rect(0, 0, 6, 5));
    EXPECT_FALSE(nearestFromTensor(tensor, {}, {2, 2}, 0));
    OrientedContour huge;
    huge.x.resize(65535);
    huge.y.resize(65535);
    huge.angleRad.resize(65535);
    EXPECT_THROW(computeDt3Tensor(huge, bins, 25, cv::Rect(0, 0, 6, 5)), Error);
}

} // namespace
} // namespace core
