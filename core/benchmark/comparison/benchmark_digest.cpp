// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/benchmark_digest.h"

namespace core {

BenchmarkDigest benchmarkDigest(const BenchmarkResults& results) {
    constexpr double kCurveStepMm = 0.1, kCurveMaxMm = 10;
    BenchmarkDigest digest;
    digest.differences = differencesOf(results);
    BenchmarkDigest::SummaryRow start{{}, {}, initialStatistics(results)};
    for (const int difference : digest.differences)
        start.byDifference.push_back(initialStatistics(results, difference));
    digest.summary.push_back(std::move(start));
    for (const std::string& method : results.methods) {
        BenchmarkDigest::SummaryRow row{method, {}, errorStatistics(results, method)};
        for (const int difference : digest.differences)
            row.byDifference.push_back(errorStatistics(results, method, difference));
        digest.summary.push_back(std::move(row));
        digest.jointErrorsMm.push_back(meanJointErrorsMm(results, method));
    }
    if (!results.rows.empty())
        digest.curves = errorCurves(results, kCurveStepMm, kCurveMaxMm);
    digest.table = pairTable(results);
    return digest;
}

} // namespace core
