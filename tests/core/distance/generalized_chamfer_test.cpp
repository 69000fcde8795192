// SPDX-License-Identifier: MIT
#include "core/distance/generalized_chamfer.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/distance/circular_distance.h"
#include "core/distance/orientation_bins.h"
#include "tests/core/distance/test_contours.h"

namespace core {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Oracle, written from the definitions alone: the terms of one model point.
std::vector<double> expectedTerms(const OrientedContour& observed, const DirectionalDistance& distance,
                                  const ChamferPenalty& penalty, double x, double y, double angle) {
    const OrientationBins bins(distance.bins, distance.isSigned);
    const bool two = distance.kind == DistanceKind::DchQuant2;
    std::vector<double> terms;
    for (int choice = 0; choice < (two ? 2 : 1); ++choice) {
        double least = kNoLimit;
        double positionPx = kNoLimit;
        double circ = 0;
        for (std::size_t i = 0; i < observed.size(); ++i) {
            const double d = std::hypot(x - observed.x[i], y - observed.y[i]);
            const int bin = bins.binOf(observed.angleRad[i]);
            const bool binned = distance.kind == DistanceKind::DchQuant || two;
            double cost = binned && bin != bins.nearestTwo(angle)[static_cast<std::size_t>(choice)] ? kNoLimit : d;
            if (distance.kind == DistanceKind::DchDt3)
                cost += distance.lambdaPxPerRad * bins.distanceRad(bin, bins.binOf(angle));
            if (cost < least) {
                least = cost;
                positionPx = d;
                circ = circularDistance(angle, observed.angleRad[i], distance.isSigned);
            }
        }
        const bool kept = least < kNoLimit && positionPx <= distance.gatePx &&
                          (distance.kind != DistanceKind::DchThres || circ < distance.tauRad);
        const double squared = penalty.kind == PenaltyKind::Absolute ? least : least * least;
        const double f =
            penalty.kind == PenaltyKind::TruncatedSquared ? std::min(squared, penalty.rejectedPx2) : squared;
        terms.push_back(kept ? f : penalty.rejectedPx2);
    }
    return terms;
}

const DistanceKind kKinds[] = {DistanceKind::Ch, DistanceKind::DchThres, DistanceKind::DchQuant,
                               DistanceKind::DchQuant2, DistanceKind::DchDt3};
const PenaltyKind kPenalties[] = {PenaltyKind::Absolute, PenaltyKind::Squared, PenaltyKind::TruncatedSquared};

TEST(DistanceTraits, StandInTheOrderOfTheKinds) {
    ASSERT_EQ(core::kDistanceTraits.size(), std::size(kKinds));
    for (const DistanceKind kind : kKinds)
        EXPECT_EQ(core::traitsOf(kind).kind, kind);
}

class EveryDistance : public ::testing::TestWithParam<std::tuple<DistanceKind, bool, PenaltyKind>> {
protected:
    DirectionalDistance distance() const {
        DirectionalDistance distance;
        distance.kind = std::get<0>(GetParam());
        distance.isSigned = std::get<1>(GetParam());
        distance.bins = 8;
        distance.gatePx = 12;
        return distance;
    }
    ChamferPenalty penalty() const { return {std::get<2>(GetParam()), 40}; }
    OrientedContour observed() const { return testing::gridContour(testing::crossingHandsMask(100, 80)); }
};

TEST_P(EveryDistance, IsTheMeanOfItsTerms) {
    const OrientedContour observed = this->observed();
    const OrientedContour model = testing::randomContour(300, 100, 80, 9); // inside and outside the image
    const ChamferScore score = generalizedChamferDistance(model, observed, distance(), penalty());
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t p = 0; p < model.size(); ++p) {
        for (const double term :
             expectedTerms(observed, distance(), penalty(), model.x[p], model.y[p], model.angleRad[p])) {
            ASSERT_LT(count, score.terms.size());
            EXPECT_EQ(score.terms[count].modelPoint, static_cast<int>(p));
            EXPECT_NEAR(score.terms[count].penalty, term, 1e-4 * (1 + term));
            sum += term;
            ++count;
        }
    }
    ASSERT_EQ(count, score.terms.size());
    EXPECT_EQ(score.kept + score.rejected, static_cast<int>(count));
    EXPECT_NEAR(score.value, sum / static_cast<double>(count), 1e-4 * score.value);
}

TEST_P(EveryDistance, FieldHoldsWhatAPointWouldCostThere) {
    const OrientedContour observed = this->observed();
    const double angle = 0.9;
    const cv::Mat field = chamferField(observed, distance(), penalty(), cv::Rect(-5, 4, 100, 70), angle);
    ASSERT_EQ(field.size(), cv::Size(100, 70));
    for (int y = 4; y < 74; y += 5) {
        for (int x = -5; x < 95; x += 5) {
            const std::vector<double> terms = expectedTerms(observed, distance(), penalty(), x, y, angle);
            double mean = 0;
            for (const double term : terms)
                mean += term / static_cast<double>(terms.size());
            // Points left of or above the region are unknown to the transform; none of this contour's are nearest here.
            if (x >= 10 && y >= 15 && x < 85 && y < 65)
                EXPECT_NEAR(field.at<float>(y - 4, x + 5), mean, 1e-3 * (1 + mean)) << x << ", " << y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryDistance,
                         ::testing::Combine(::testing::ValuesIn(kKinds), ::testing::Bool(),
                                            ::testing::ValuesIn(kPenalties)));

TEST(GeneralizedChamfer, IsZeroOnTheContourItself) {
    const OrientedContour contour = testing::gridContour(testing::crossingHandsMask(100, 80));
    for (const DistanceKind kind : {DistanceKind::Ch, DistanceKind::DchQuant, DistanceKind::DchDt3}) {
        DirectionalDistance distance;
        distance.kind = kind;
        EXPECT_EQ(generalizedChamferDistance(contour, contour, distance).value, 0);
    }
}

TEST(GeneralizedChamfer, ChargesKForAnEmptyContourAndNothingForAnEmptyModel) {
    const OrientedContour model = testing::randomContour(10, 20, 20, 1);
    const ChamferScore score = generalizedChamferDistance(model, {}, {}, {PenaltyKind::Squared, 77});
    EXPECT_EQ(score.value, 77);
    EXPECT_EQ(score.rejected, 10);
    EXPECT_EQ(generalizedChamferDistance({}, model, {}).value, 0);
}

} // namespace
} // namespace core
