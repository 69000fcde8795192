// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"

namespace core {

/// What is known of a pair, or of one method's result of it.
enum class PairField {
    Sequence, ///< a text: its value is NaN
    Start,
    Test,
    Difference, ///< test - start, frames
    StartErrorMm,
    ErrorMm,           ///< of `method`
    ErrorDifferenceMm, ///< error of `method` minus that of `other`: above 0 where `method` is the worse one
    Iterations,
    Seconds
};

/// A field with the methods it is of, as indices into PairTable::methods.
struct PairQuantity {
    PairField field = PairField::ErrorMm;
    std::size_t method = 0;
    std::size_t other = 0;
    bool operator==(const PairQuantity&) const = default;
};

/// Results of a benchmark with one row per pair, the methods side by side.
struct PairTable {
    /// Per pair; NaN where the method has no result.
    struct Column {
        std::vector<double> errorMm;
        std::vector<double> iterations;
        std::vector<double> seconds;
    };
    std::vector<std::string> methods; ///< in the order of the results
    std::vector<FramePair> pairs;     ///< those with a result at least, in the order of their first one
    std::vector<double> startErrorMm; ///< per pair
    std::vector<Column> columns;      ///< per method
};

PairTable pairTable(const BenchmarkResults& results);

/// NaN for a text, and where a method has no result.
double pairValue(const PairTable& table, const PairQuantity& quantity, std::size_t pair);

/// The given pairs from the smallest value (or the largest) on, texts by the alphabet; those without a value come last.
/// Equal ones keep their order.
std::vector<std::size_t> sortedPairs(const PairTable& table, std::vector<std::size_t> pairs,
                                     const PairQuantity& quantity, bool descending);

} // namespace core
