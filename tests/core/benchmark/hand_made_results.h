// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "core/benchmark/benchmark_results.h"

namespace test {

/// Four pairs, 1 and 5 frames apart, by ch (errors 1, 3, 5, 7 mm) and by another tracker (2 mm, on the first pair
/// alone).
inline core::BenchmarkResults handMadeResults() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    core::BenchmarkResults results;
    results.joints = {{core::Side::Left, "forearm"}, {core::Side::Left, "index_mcp"}, {core::Side::Right, "forearm"}};
    results.pairs = {{"01", 19, 20}, {"01", 29, 30}, {"01", 15, 20}, {"01", 25, 30}};
    results.methods = {"ch", "their, tracker"};
    results.external = {"their, tracker"};
    for (std::size_t i = 0; i < 4; ++i) {
        const double error = 1 + 2 * static_cast<double>(i);
        const double initial = 10 * (i == 0 ? 1 : i == 1 ? 3 : i == 2 ? 2 : 4);
        results.rows.push_back({results.pairs[i],
                                "ch",
                                initial,
                                error,
                                10,
                                1,
                                0.125 * (i == 0   ? 4
                                         : i == 1 ? 2
                                         : i == 2 ? 6
                                                  : 4),
                                {error, i == 0 ? 1 : kNone, kNone}});
    }
    results.rows.push_back({results.pairs[0], "their, tracker", 10, 2, 0, 0, 0, {2, kNone, 2}});
    core::sortRows(results);
    return results;
}

} // namespace test
