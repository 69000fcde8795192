// SPDX-License-Identifier: MIT
#include "core/distance/distance_transform.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/distance/test_contours.h"

namespace core {
namespace {

using testing::crossingHandsMask;
using testing::gridContour;
using testing::randomContour;

/// Oracle: every pixel against every point that `qualifies`, in integers; the smallest index of the nearest ones.
template <typename Qualifies>
void expectExact(const DistanceTransform& transform, const OrientedContour& contour, const Qualifies& qualifies) {
    const cv::Rect& region = transform.region;
    for (int y = region.y; y < region.br().y; ++y) {
        for (int x = region.x; x < region.br().x; ++x) {
            long best = std::numeric_limits<long>::max();
            int index = -1;
            for (std::size_t i = 0; i < contour.size(); ++i) {
                const cv::Point q(static_cast<int>(contour.x[i]), static_cast<int>(contour.y[i]));
                const long squared = long{q.x - x} * (q.x - x) + long{q.y - y} * (q.y - y);
                if (region.contains(q) && squared < best && qualifies(i)) {
                    best = squared;
                    index = static_cast<int>(i);
                }
            }
            ASSERT_EQ(transform.nearest[transform.at(x, y)], index) << "at " << x << ", " << y;
            const float expected =
                index < 0 ? std::numeric_limits<float>::infinity() : std::sqrt(static_cast<float>(best));
            ASSERT_EQ(transform.distancePx[transform.at(x, y)], expected) << "at " << x << ", " << y;
        }
    }
}

bool all(std::size_t) {
    return true;
}

TEST(DistanceTransform, IsExactOnAContourWithHolesThatLeavesTheImage) {
    const cv::Mat mask = crossingHandsMask(150, 110);
    const OrientedContour contour = gridContour(mask);
    cv::Mat labels;
    ASSERT_GE(cv::connectedComponents(mask == 0, labels), 4) << "above, below, at least one hole, and label 0";
    ASSERT_GT(cv::countNonZero(mask.col(0)), 0) << "the arm leaves the image";
    expectExact(computeDistanceTransform(contour, cv::Rect(0, 0, 150, 110)), contour, all);
}

TEST(DistanceTransform, IsExactWithTiesDuplicatesAndPointsOutsideTheRegion) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const OrientedContour contour = randomContour(1 + static_cast<int>(seed * seed / 4), 23, 17, seed);
        expectExact(computeDistanceTransform(contour, cv::Rect(0, 0, 23, 17)), contour, all);
        expectExact(computeDistanceTransform(contour, cv::Rect(-3, 4, 11, 20)), contour, all);
    }
}

TEST(DistanceTransform, GivesTiesToTheSmallerIndexOnARegularGrid) {
    OrientedContour contour;
    for (int i = 0; i < 30; ++i) {
        const int scattered = (i * 17) % 30;
        contour.x.push_back(static_cast<float>(4 * (scattered % 6)));
        contour.y.push_back(static_cast<float>(4 * (scattered / 6)));
        contour.angleRad.push_back(0);
    }
    expectExact(computeDistanceTransform(contour, cv::Rect(0, 0, 21, 17)), contour, all);
}

TEST(DistanceTransform, IsInfiniteWithoutPoints) {
    const DistanceTransform transform = computeDistanceTransform({}, cv::Rect(2, 3, 5, 4));
    ASSERT_EQ(transform.distancePx.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(transform.distancePx[i], std::numeric_limits<float>::infinity());
        EXPECT_EQ(transform.nearest[i], -1);
    }
    EXPECT_FALSE(nearestFromTransform(transform, {}, {3, 4}));
    EXPECT_FALSE(nearestFromTransform(transform, {}, {30, 40}));
}

TEST(DistanceTransform, OfEachBinIsExactAndEmptyBinsAreInfinite) {
    const OrientedContour contour = gridContour(crossingHandsMask(90, 70));
    OrientedContour half = contour; // nothing points up: some signed bins are empty
    for (float& angle : half.angleRad)
        angle = std::abs(angle);
    for (const bool isSigned : {true, false}) {
        const OrientationBins bins(16, isSigned);
        const auto transforms = computeBinTransforms(half, bins, cv::Rect(0, 0, 90, 70));
        ASSERT_EQ(transforms.size(), 16u);
        for (int bin = 0; bin < 16; ++bin) {
            expectExact(
                transforms[static_cast<std::size_t>(bin)], half,
                [&](std::size_t i) { return bins.binOf(half.angleRad[i]) == bin; });
        }
    }
}

TEST(DistanceTransform, AnswersBetweenPixelsAndOutsideTheRegion) {
    const OrientedContour contour = gridContour(crossingHandsMask(150, 110));
    const DistanceTransform transform = computeDistanceTransform(contour, cv::Rect(0, 0, 150, 110));
    for (double x = -40.3; x < 190; x += 7.7) {
        for (double y = -30.6; y < 140; y += 6.3) {
            const auto match = nearestFromTransform(transform, contour, {x, y});
            const auto exact = nearestPoint(contour, {x, y});
            ASSERT_TRUE(match && exact);
            EXPECT_DOUBLE_EQ(match->distancePx, distancePx(contour, match->index, {x, y}));
            const bool inside = x > -0.5 && x < 149.5 && y > -0.5 && y < 109.5;
            EXPECT_LE(match->distancePx, exact->distancePx + (inside ? std::sqrt(2.0) : 0.0));
        }
    }
}

TEST(DistanceTransform, OfABinAnswersWithinThatBinBetweenPixelsAndOutsideTheRegion) {
    const OrientedContour contour = gridContour(crossingHandsMask(90, 70));
    const OrientationBins bins(8, true);
    const auto transforms = computeBinTransforms(contour, bins, cv::Rect(0, 0, 90, 70));
    int answers = 0;
    for (int bin = 0; bin < bins.count(); ++bin) {
        for (double x = -20.3; x < 110; x += 7.7) {
            for (double y = -20.6; y < 90; y += 6.3) {
                const auto match = nearestFromBinTransforms(transforms, contour, bins, bin, {x, y});
                const auto exact = nearestPointInBin(contour, bins, bin, {x, y});
                ASSERT_EQ(match.has_value(), exact.has_value());
                if (!exact)
                    continue;
                ++answers;
                EXPECT_EQ(bins.binOf(contour.angleRad[static_cast<std::size_t>(match->index)]), bin);
                EXPECT_DOUBLE_EQ(match->distancePx, distancePx(contour, match->index, {x, y}));
                const bool inside = x > -0.5 && x < 89.5 && y > -0.5 && y < 69.5;
                EXPECT_LE(match->distancePx, exact->distancePx + (inside ? std::sqrt(2.0) : 0.0));
            }
        }
    }
    EXPECT_GT(answers, 500);
}

TEST(DistanceTransform, OfAnEmptyBinHasNoAnswer) {
    OrientedContour contour = gridContour(crossingHandsMask(90, 70));
    for (float& angle : contour.angleRad)
        angle = 0;
    const OrientationBins bins(4, true);
    const auto transforms = computeBinTransforms(contour, bins, cv::Rect(0, 0, 90, 70));
    EXPECT_TRUE(nearestFromBinTransforms(transforms, contour, bins, 0, {40, 30}));
    for (int bin = 1; bin < 4; ++bin) {
        EXPECT_FALSE(nearestFromBinTransforms(transforms, contour, bins, bin, {40, 30}));
        EXPECT_FALSE(nearestFromBinTransforms(transforms, contour, bins, bin, {-40, 300}));
    }
}

} // namespace
} // namespace core
