// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/pair_distribution.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace core {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

TEST(PairDistribution, CountsEveryValueInItsRange) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(1, 3);
    std::vector<double> values{kNoValue};
    for (int i = 0; i < 2000; ++i)
        values.push_back(normal(random));
    const Histogram histogram = roundHistogram(values);
    EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0), 2000);
    EXPECT_GE(histogram.counts.size(), 10u);
    EXPECT_LE(histogram.counts.size(), 42u);
    const double edges = histogram.from / histogram.width;
    EXPECT_NEAR(edges, std::round(edges), 1e-9) << "an edge lies at 0";
    for (std::size_t bin = 1; bin + 1 < histogram.counts.size(); ++bin) { // those at the ends hold the rest
        const double low = histogram.from + static_cast<double>(bin) * histogram.width;
        const auto counted = std::count_if(values.begin(), values.end(),
                                           [&](double value) { return value >= low && value < low + histogram.width; });
        EXPECT_NEAR(histogram.counts[bin], static_cast<double>(counted), 1) << low;
    }
}

TEST(PairDistribution, ManagesFewAndEqualValues) {
    EXPECT_TRUE(roundHistogram({}).counts.empty());
    EXPECT_TRUE(roundHistogram({kNoValue}).counts.empty());
    EXPECT_EQ(roundHistogram({0, 0, 0}).counts, (std::vector<int>{3}));
    const Histogram one = roundHistogram({2.5});
    EXPECT_EQ(one.counts.back(), 1);
    EXPECT_LE(one.from, 0);
}

TEST(PairDistribution, BoxesAreQuantiles) {
    std::vector<double> values(101);
    std::iota(values.begin(), values.end(), 0);
    std::shuffle(values.begin(), values.end(), std::mt19937(5));
    values.push_back(kNoValue);
    const BoxStatistics box = boxStatistics(values);
    EXPECT_EQ(box.count, 101u);
    EXPECT_DOUBLE_EQ(box.low, 5);
    EXPECT_DOUBLE_EQ(box.lowerQuartile, 25);
    EXPECT_DOUBLE_EQ(box.median, 50);
    EXPECT_DOUBLE_EQ(box.upperQuartile, 75);
    EXPECT_DOUBLE_EQ(box.high, 95);
    EXPECT_DOUBLE_EQ(boxStatistics({1, 2}).median, 1.5);
    EXPECT_EQ(boxStatistics({kNoValue}).count, 0u);
}

} // namespace
} // namespace core
