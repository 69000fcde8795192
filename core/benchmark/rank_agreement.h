// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"

namespace core {

/// How far two rankings of the same methods agree: Kendall's tau-b, 1 the same order, -1 the reverse, with the interval
/// that holds 95 % of it when the frame pairs are drawn again (bootstrap, percentiles).
struct RankAgreement {
    double tau = 0;
    double low = 0;
    double high = 0;
};

/// Kendall's tau-b (1945) of two lists of equal length; values nearer than `tie` count as equal. NaN if one of the
/// lists has no order at all.
double kendallTau(const std::vector<double>& a, const std::vector<double>& b, double tie = 0);

/// Ranks `methods` by their mean error over all pairs that every one of them has, in both results. The pairs are drawn
/// again together where both results have the same, else independently. Deterministic.
RankAgreement rankAgreement(const BenchmarkResults& a, const BenchmarkResults& b,
                            const std::vector<std::string>& methods, std::uint64_t seed = 1, int resamples = 1000);

/// The methods of results from the smallest mean error to the largest: "best < dch-thres < ch".
std::string orderText(const BenchmarkResults& results, const std::vector<std::string>& methods);

} // namespace core
