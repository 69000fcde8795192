// SPDX-License-Identifier: MIT
#include "core/benchmark/benchmark_results.h"

#include <algorithm>
#include <map>
#include <set>

namespace core {

void sortRows(BenchmarkResults& results) {
    std::map<FramePair, std::size_t> pairRank;
    for (const FramePair& pair : results.pairs)
        pairRank.emplace(pair, pairRank.size());
    std::map<std::string, std::size_t> methodRank;
    for (const std::string& method : results.methods)
        methodRank.emplace(method, methodRank.size());
    const auto rank = [&](const PairResult& row) {
        return std::pair(pairRank.at(row.pair), methodRank.at(row.method));
    };
    std::stable_sort(results.rows.begin(), results.rows.end(),
                     [&](const PairResult& a, const PairResult& b) { return rank(a) < rank(b); });
}

std::vector<PairResult> rowsOfPairs(const std::vector<PairResult>& rows, const std::vector<FramePair>& pairs) {
    const std::set<FramePair> wanted(pairs.begin(), pairs.end());
    std::vector<PairResult> found;
    for (const PairResult& row : rows)
        if (wanted.contains(row.pair))
            found.push_back(row);
    return found;
}

void addExternalRows(BenchmarkResults& results, const std::vector<std::string>& names,
                     const std::vector<PairResult>& rows) {
    results.methods.insert(results.methods.end(), names.begin(), names.end());
    results.external.insert(results.external.end(), names.begin(), names.end());
    results.rows.insert(results.rows.end(), rows.begin(), rows.end());
    sortRows(results);
}

} // namespace core
