// SPDX-License-Identifier: MIT
#include "core/benchmark/rank_agreement.h"

#include <cmath>

#include <gtest/gtest.h>

namespace core {
namespace {

TEST(KendallTau, CountsPairsInTheSameOrder) {
    EXPECT_DOUBLE_EQ(kendallTau({1, 2, 3}, {10, 20, 30}), 1);
    EXPECT_DOUBLE_EQ(kendallTau({1, 2, 3}, {30, 20, 10}), -1);
    EXPECT_DOUBLE_EQ(kendallTau({1, 2, 3, 4}, {1, 3, 2, 4}), 4.0 / 6);
    EXPECT_NEAR(kendallTau({1, 2, 2, 3}, {1, 3, 2, 4}), 5 / std::sqrt(30.0), 1e-12) << "ties as in tau-b";
    EXPECT_TRUE(std::isnan(kendallTau({1, 1}, {1, 2})));
}

/// Errors of three methods over pairs: base + noise by pair number.
BenchmarkResults resultsOf(const std::vector<double>& meansMm, double spreadMm) {
    BenchmarkResults results;
    results.methods = {"ch", "dch-thres", "best"};
    for (int i = 0; i < 40; ++i) {
        const FramePair pair{"a", i, i + 5};
        results.pairs.push_back(pair);
        for (std::size_t m = 0; m < 3; ++m) {
            const double noise = spreadMm * std::sin(1.0 + 7.0 * i + 3.0 * static_cast<double>(m));
            results.rows.push_back({pair, results.methods[m], 10, meansMm[m] + noise, 1, 0, 0.1, {}});
        }
    }
    return results;
}

TEST(RankAgreement, IsCertainWhereMethodsAreFarApart) {
    const BenchmarkResults clean = resultsOf({3, 2, 1}, 0.1);
    const RankAgreement same = rankAgreement(clean, resultsOf({6, 5, 4}, 0.1), clean.methods);
    EXPECT_DOUBLE_EQ(same.tau, 1);
    EXPECT_DOUBLE_EQ(same.low, 1);
    EXPECT_DOUBLE_EQ(same.high, 1);
    EXPECT_DOUBLE_EQ(rankAgreement(clean, resultsOf({4, 5, 6}, 0.1), clean.methods).tau, -1);
    EXPECT_EQ(orderText(clean, clean.methods), "best < dch-thres < ch");
}

TEST(RankAgreement, IsUncertainWhereTheyAreNear) {
    const BenchmarkResults clean = resultsOf({3, 2, 1}, 0.1);
    const RankAgreement near = rankAgreement(clean, resultsOf({5, 5.01, 5}, 4), clean.methods);
    EXPECT_LT(near.low, near.high);
    const RankAgreement again = rankAgreement(clean, resultsOf({5, 5.01, 5}, 4), clean.methods);
    EXPECT_EQ(near.low, again.low);
}

} // namespace
} // namespace core
