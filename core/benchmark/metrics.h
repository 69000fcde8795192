// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"

namespace core {

/// Mean and (population) standard deviation of the errors of some pairs, mm, and of what they took.
struct ErrorStatistics {
    int pairs = 0; ///< all else is 0 if there are none
    double meanMm = 0;
    double stdMm = 0;
    double medianMm = 0;
    double worstMm = 0;
    double meanSeconds = 0;
    double meanIterations = 0;
    double costRisesPerIteration = 0; ///< share of the iterations that raised the cost: 0 = perfectly smooth
};

/// Over the pairs of a method, of one difference or of all.
ErrorStatistics errorStatistics(const BenchmarkResults& results, const std::string& method,
                                std::optional<int> difference = {});
/// The same of the start poses, every pair once.
ErrorStatistics initialStatistics(const BenchmarkResults& results, std::optional<int> difference = {});

/// The differences that occur, ascending.
std::vector<int> differencesOf(const BenchmarkResults& results);

/// Share of the pairs whose error is below each threshold.
struct ErrorCurve {
    std::string method;
    std::vector<double> thresholdsMm;
    std::vector<double> share; ///< in [0, 1]
};
/// One curve per method, thresholds 0, step, ... up to maxMm; the first is that of the start poses, named "initial".
std::vector<ErrorCurve> errorCurves(const BenchmarkResults& results, double stepMm = 0.1, double maxMm = 20);

/// Mean error of every joint, parallel to results.joints, mm; NaN for a joint that no pair has.
std::vector<double> meanJointErrorsMm(const BenchmarkResults& results, const std::string& method);

/// The pairs with the largest errors of a method, the worst first.
std::vector<PairResult> worstPairs(const BenchmarkResults& results, const std::string& method, std::size_t count);

} // namespace core
