// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/comparison/pair_table.h"
#include "core/benchmark/metrics.h"

namespace core {

/// All that a window shows of results: plain numbers, made once, so that many results are not gone through again for
/// every picture.
struct BenchmarkDigest {
    /// Start poses (an empty name) or a method.
    struct SummaryRow {
        std::string method;
        std::vector<ErrorStatistics> byDifference; ///< parallel to `differences`
        ErrorStatistics all;
    };
    std::vector<int> differences;
    std::vector<SummaryRow> summary;                ///< the start poses first, then the methods in their order
    std::vector<ErrorCurve> curves;                 ///< up to 10 mm in steps of 0.1
    std::vector<std::vector<double>> jointErrorsMm; ///< means per method, parallel to the results' joints
    PairTable table;
};

BenchmarkDigest benchmarkDigest(const BenchmarkResults& results);

} // namespace core
