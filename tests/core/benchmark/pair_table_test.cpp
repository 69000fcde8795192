// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/pair_table.h"

#include <chrono>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/core/benchmark/hand_made_results.h"

namespace core {
namespace {

using test::handMadeResults;

TEST(PairTable, HasARowPerPairAndAColumnPerMethod) {
    const BenchmarkResults results = handMadeResults();
    const PairTable table = pairTable(results);
    ASSERT_EQ(table.pairs.size(), 4u);
    EXPECT_EQ(table.methods, results.methods);
    for (const PairResult& row : results.rows) {
        const auto pair =
            static_cast<std::size_t>(std::find(table.pairs.begin(), table.pairs.end(), row.pair) - table.pairs.begin());
        const std::size_t method = row.method == "ch" ? 0 : 1;
        EXPECT_EQ(pairValue(table, {PairField::ErrorMm, method, 0}, pair), row.errorMm);
        EXPECT_EQ(pairValue(table, {PairField::Iterations, method, 0}, pair), row.iterations);
        EXPECT_EQ(pairValue(table, {PairField::Seconds, method, 0}, pair), row.seconds);
        EXPECT_EQ(pairValue(table, {PairField::StartErrorMm, 0, 0}, pair), row.initialErrorMm);
        EXPECT_EQ(pairValue(table, {PairField::Difference, 0, 0}, pair), row.pair.difference());
    }
    EXPECT_EQ(pairValue(table, {PairField::ErrorDifferenceMm, 0, 1}, 0), 1 - 2);
    EXPECT_TRUE(std::isnan(pairValue(table, {PairField::ErrorDifferenceMm, 0, 1}, 1))) << "the tracker has no result";
}

TEST(PairTable, SortsByAValueWithGapsAtTheEnd) {
    const PairTable table = pairTable(handMadeResults());
    const auto sorted = [&](const PairQuantity& quantity, bool descending) {
        return sortedPairs(table, {0, 1, 2, 3}, quantity, descending);
    };
    EXPECT_EQ(sorted({PairField::StartErrorMm, 0, 0}, false), (std::vector<std::size_t>{0, 2, 1, 3}));
    EXPECT_EQ(sorted({PairField::ErrorMm, 0, 0}, true), (std::vector<std::size_t>{3, 2, 1, 0}));
    for (const bool descending : {false, true}) {
        EXPECT_EQ(sorted({PairField::ErrorMm, 1, 0}, descending), (std::vector<std::size_t>{0, 1, 2, 3}))
            << "three have no value";
        EXPECT_EQ(sorted({PairField::Sequence, 0, 0}, descending), (std::vector<std::size_t>{0, 1, 2, 3}))
            << "equal ones keep their order";
    }
}

TEST(PairTable, TakesAHundredThousandResultsWithoutDelay) {
    BenchmarkResults results;
    results.methods = {"ch", "dch-thres", "dch-quant", "dch-dt3"};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> error(0, 20);
    for (int i = 0; i < 25000; ++i)
        for (const std::string& method : results.methods) {
            PairResult row;
            row.pair = {"0" + std::to_string(i % 4), i, i + 1 + i % 15};
            row.method = method;
            row.errorMm = error(random);
            results.rows.push_back(row);
        }
    const auto began = std::chrono::steady_clock::now();
    const PairTable table = pairTable(results);
    const auto sorted = sortedPairs(table, std::vector<std::size_t>{0, 1, 2}, {PairField::ErrorMm, 0, 0}, true);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    EXPECT_EQ(table.pairs.size(), 25000u);
    EXPECT_EQ(sorted.size(), 3u);
    EXPECT_LT(took.count(), 2.0);
}

} // namespace
} // namespace core
