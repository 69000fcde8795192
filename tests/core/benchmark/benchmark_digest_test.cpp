// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/benchmark_digest.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

TEST(BenchmarkDigest, HoldsWhatTheMetricsSay) {
    const BenchmarkResults results = test::handMadeResults();
    const BenchmarkDigest digest = benchmarkDigest(results);
    EXPECT_EQ(digest.differences, (std::vector<int>{1, 5}));
    ASSERT_EQ(digest.summary.size(), 3u);
    EXPECT_DOUBLE_EQ(digest.summary[0].all.meanMm, 25) << "start poses";
    EXPECT_EQ(digest.summary[1].method, "ch");
    EXPECT_DOUBLE_EQ(digest.summary[1].all.meanMm, 4);
    EXPECT_DOUBLE_EQ(digest.summary[1].byDifference[0].meanMm, 2);
    EXPECT_DOUBLE_EQ(digest.summary[1].byDifference[1].meanMm, 6);
    EXPECT_EQ(digest.summary[2].byDifference[1].pairs, 0);
    ASSERT_EQ(digest.curves.size(), 3u);
    EXPECT_DOUBLE_EQ(digest.curves[1].share.back(), 1);
    EXPECT_DOUBLE_EQ(digest.jointErrorsMm[0][0], 4);
    EXPECT_TRUE(std::isnan(digest.jointErrorsMm[0][2]));
    EXPECT_EQ(digest.table.pairs.size(), 4u);
    EXPECT_TRUE(benchmarkDigest({}).curves.empty());
}

} // namespace
} // namespace core
