// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/pair_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace core {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

struct FramePairHash {
    std::size_t operator()(const FramePair& pair) const {
        const auto frames = static_cast<std::size_t>(pair.start) * 1000003u + static_cast<std::size_t>(pair.test);
        return std::hash<std::string>()(pair.sequence) ^ (frames * 0x9E3779B97F4A7C15u);
    }
};

std::size_t indexIn(const std::vector<std::string>& methods, const std::string& method) {
    return static_cast<std::size_t>(std::find(methods.begin(), methods.end(), method) - methods.begin());
}

} // namespace

PairTable pairTable(const BenchmarkResults& results) {
    PairTable table;
    table.methods = results.methods;
    table.columns.resize(table.methods.size());
    std::unordered_map<FramePair, std::size_t, FramePairHash> places;
    std::vector<std::size_t> placeOfRow(results.rows.size());
    for (std::size_t i = 0; i < results.rows.size(); ++i) {
        const auto [found, isNew] = places.emplace(results.rows[i].pair, places.size());
        placeOfRow[i] = found->second;
        if (isNew) {
            table.pairs.push_back(results.rows[i].pair);
            table.startErrorMm.push_back(results.rows[i].initialErrorMm);
        }
    }
    for (PairTable::Column& column : table.columns)
        for (std::vector<double>* values : {&column.errorMm, &column.iterations, &column.seconds})
            values->assign(table.pairs.size(), kNoValue);
    for (std::size_t i = 0; i < results.rows.size(); ++i) {
        const PairResult& row = results.rows[i];
        const std::size_t method = indexIn(table.methods, row.method);
        if (method == table.methods.size())
            continue;
        PairTable::Column& column = table.columns[method];
        column.errorMm[placeOfRow[i]] = row.errorMm;
        column.iterations[placeOfRow[i]] = row.iterations;
        column.seconds[placeOfRow[i]] = row.seconds;
    }
    return table;
}

double pairValue(const PairTable& table, const PairQuantity& quantity, std::size_t pair) {
    switch (quantity.field) {
    case PairField::Sequence:
        return kNoValue;
    case PairField::Start:
        return table.pairs[pair].start;
    case PairField::Test:
        return table.pairs[pair].test;
    case PairField::Difference:
        return table.pairs[pair].difference();
    case PairField::StartErrorMm:
        return table.startErrorMm[pair];
    case PairField::ErrorMm:
        return table.columns[quantity.method].errorMm[pair];
    case PairField::ErrorDifferenceMm:
        return table.columns[quantity.method].errorMm[pair] - table.columns[quantity.other].errorMm[pair];
    case PairField::Iterations:
        return table.columns[quantity.method].iterations[pair];
    case PairField::Seconds:
        return table.columns[quantity.method].seconds[pair];
    }
    return kNoValue;
}

std::vector<std::size_t> sortedPairs(const PairTable& table, std::vector<std::size_t> pairs,
                                     const PairQuantity& quantity, bool descending) {
    if (quantity.field == PairField::Sequence) {
        std::stable_sort(pairs.begin(), pairs.end(), [&](std::size_t a, std::size_t b) {
            const int order = table.pairs[a].sequence.compare(table.pairs[b].sequence);
            return descending ? order > 0 : order < 0;
        });
        return pairs;
    }
    std::vector<double> values(table.pairs.size());
    for (const std::size_t pair : pairs)
        values[pair] = pairValue(table, quantity, pair);
    std::stable_sort(pairs.begin(), pairs.end(), [&](std::size_t a, std::size_t b) {
        if (std::isnan(values[a]) || std::isnan(values[b]))
            return !std::isnan(values[a]) && std::isnan(values[b]);
        return descending ? values[a] > values[b] : values[a] < values[b];
    });
    return pairs;
}

} // namespace core
