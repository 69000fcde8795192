// SPDX-License-Identifier: MIT
#include "core/benchmark/metrics.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

using test::handMadeResults;

TEST(Metrics, AreThoseOfTheHandMadeResults) {
    const ErrorStatistics all = errorStatistics(handMadeResults(), "ch");
    EXPECT_EQ(all.pairs, 4);
    EXPECT_DOUBLE_EQ(all.meanMm, 4);             // 1 3 5 7
    EXPECT_DOUBLE_EQ(all.stdMm, std::sqrt(5.0)); // of the population
    EXPECT_DOUBLE_EQ(all.medianMm, 4);
    EXPECT_DOUBLE_EQ(all.worstMm, 7);
    EXPECT_DOUBLE_EQ(all.meanSeconds, 0.5);
    EXPECT_DOUBLE_EQ(all.meanIterations, 10);
    EXPECT_DOUBLE_EQ(all.costRisesPerIteration, 0.1);
    const ErrorStatistics one = errorStatistics(handMadeResults(), "ch", 1);
    EXPECT_EQ(one.pairs, 2);
    EXPECT_DOUBLE_EQ(one.meanMm, 2);
    EXPECT_DOUBLE_EQ(one.stdMm, 1);
    EXPECT_EQ(errorStatistics(handMadeResults(), "ch", 10).pairs, 0);
    EXPECT_EQ(errorStatistics(handMadeResults(), "best").pairs, 0);
}

TEST(Metrics, CountTheStartOfEveryPairOnce) {
    const ErrorStatistics initial = initialStatistics(handMadeResults());
    EXPECT_EQ(initial.pairs, 4);
    EXPECT_DOUBLE_EQ(initial.meanMm, 25); // 10 20 30 40
    EXPECT_DOUBLE_EQ(initialStatistics(handMadeResults(), 5).meanMm, 30);
    EXPECT_EQ(differencesOf(handMadeResults()), (std::vector<int>{1, 5}));
}

TEST(Metrics, CurvesCountThePairsBelowEachThreshold) {
    const std::vector<ErrorCurve> curves = errorCurves(handMadeResults(), 1, 8);
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_EQ(curves[0].method, "initial");
    EXPECT_EQ(curves[0].share.back(), 0);
    EXPECT_EQ(curves[1].method, "ch");
    EXPECT_EQ(curves[1].share, (std::vector<double>{0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1}));
    EXPECT_EQ(curves[1].thresholdsMm[3], 3);
}

TEST(Metrics, JointMeansSkipMissingJoints) {
    const std::vector<double> means = meanJointErrorsMm(handMadeResults(), "ch");
    ASSERT_EQ(means.size(), 3u);
    EXPECT_DOUBLE_EQ(means[0], 4);
    EXPECT_DOUBLE_EQ(means[1], 1); // only the first pair has it
    EXPECT_TRUE(std::isnan(means[2]));
}

TEST(Metrics, WorstPairsComeFirst) {
    const std::vector<PairResult> worst = worstPairs(handMadeResults(), "ch", 2);
    ASSERT_EQ(worst.size(), 2u);
    EXPECT_EQ(worst[0].errorMm, 7);
    EXPECT_EQ(worst[1].errorMm, 5);
    EXPECT_EQ(worstPairs(handMadeResults(), "ch", 20).size(), 4u);
}

} // namespace
} // namespace core
