// SPDX-License-Identifier: MIT
#include "core/benchmark/benchmark_results.h"

#include <algorithm>
#include <map>

namespace core {

void sortRows(BenchmarkResults& results) {
    std::map<FramePair, std::size_t> pairRank;
    for (const FramePair& pair : results.pairs) {
        pairRank.emplace(pair, pairRank.size());
    }
    std::map<std::string, std::size_t> methodRank;
    for (const std::string& method : results.methods) {
        methodRank.emplace(method, methodRank.size());
    }
    const auto rank = [&](const PairResult& row) {
        return std::pair(pairRank.at(row.pair), methodRank.at(row.method));
    };
    std::stable_sort(results.rows.begin(), results.rows.end(),
                     [&](const PairResult& a, const PairResult& b) { return rank(a) < rank(b); });
}

} // namespace core
