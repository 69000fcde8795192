// SPDX-License-Identifier: MIT
#include "core/benchmark/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/numeric/median.h"

namespace core {

namespace {

using Rows = std::vector<const PairResult*>;

Rows rowsOf(const BenchmarkResults& results, const std::string& method, std::optional<int> difference) {
    Rows rows;
    for (const PairResult& row : results.rows)
        if (row.method == method && (!difference || row.pair.difference() == *difference))
            rows.push_back(&row);
    return rows;
}

/// The first row of every pair: all rows of a pair have the same start.
Rows firstRows(const BenchmarkResults& results, std::optional<int> difference) {
    Rows rows;
    std::set<FramePair> seen;
    for (const PairResult& row : results.rows)
        if ((!difference || row.pair.difference() == *difference) && seen.insert(row.pair).second)
            rows.push_back(&row);
    return rows;
}

std::vector<double> errorsOf(const Rows& rows, double PairResult::*error) {
    std::vector<double> errors;
    for (const PairResult* row : rows)
        errors.push_back(row->*error);
    return errors;
}

ErrorStatistics statisticsOf(std::vector<double> errorsMm) {
    ErrorStatistics statistics;
    statistics.pairs = static_cast<int>(errorsMm.size());
    if (errorsMm.empty())
        return statistics;
    statistics.meanMm = meanOf(errorsMm);
    double squares = 0;
    for (const double error : errorsMm)
        squares += (error - statistics.meanMm) * (error - statistics.meanMm);
    statistics.stdMm = std::sqrt(squares / static_cast<double>(errorsMm.size()));
    statistics.worstMm = *std::max_element(errorsMm.begin(), errorsMm.end());
    statistics.medianMm = medianOf(std::move(errorsMm));
    return statistics;
}

ErrorCurve curveOf(const std::string& method, std::vector<double> errorsMm, double stepMm, double maxMm) {
    ErrorCurve curve{method, {}, {}};
    std::sort(errorsMm.begin(), errorsMm.end());
    const auto count = static_cast<double>(errorsMm.size());
    for (int i = 0; i * stepMm <= maxMm + 1e-9; ++i) {
        const double threshold = i * stepMm;
        const auto below = std::lower_bound(errorsMm.begin(), errorsMm.end(), threshold) - errorsMm.begin();
        curve.thresholdsMm.push_back(threshold);
        curve.share.push_back(errorsMm.empty() ? 0 : static_cast<double>(below) / count);
    }
    return curve;
}

} // namespace

ErrorStatistics errorStatistics(const BenchmarkResults& results, const std::string& method,
                                std::optional<int> difference) {
    const Rows rows = rowsOf(results, method, difference);
    ErrorStatistics statistics = statisticsOf(errorsOf(rows, &PairResult::errorMm));
    statistics.meanSeconds = meanOf(errorsOf(rows, &PairResult::seconds));
    double iterations = 0;
    double rises = 0;
    for (const PairResult* row : rows) {
        iterations += row->iterations;
        rises += row->costRises;
    }
    statistics.meanIterations = rows.empty() ? 0 : iterations / static_cast<double>(rows.size());
    statistics.costRisesPerIteration = iterations > 0 ? rises / iterations : 0;
    return statistics;
}

ErrorStatistics initialStatistics(const BenchmarkResults& results, std::optional<int> difference) {
    return statisticsOf(errorsOf(firstRows(results, difference), &PairResult::initialErrorMm));
}

std::vector<int> differencesOf(const BenchmarkResults& results) {
    std::set<int> differences;
    for (const FramePair& pair : results.pairs)
        differences.insert(pair.difference());
    return {differences.begin(), differences.end()};
}

std::vector<ErrorCurve> errorCurves(const BenchmarkResults& results, double stepMm, double maxMm) {
    std::vector<ErrorCurve> curves;
    const Rows pairs = firstRows(results, {});
    curves.push_back(curveOf("initial", errorsOf(pairs, &PairResult::initialErrorMm), stepMm, maxMm));
    for (const std::string& method : results.methods) {
        const Rows rows = rowsOf(results, method, {});
        curves.push_back(curveOf(method, errorsOf(rows, &PairResult::errorMm), stepMm, maxMm));
    }
    return curves;
}

std::vector<double> meanJointErrorsMm(const BenchmarkResults& results, const std::string& method) {
    std::vector<double> sums(results.joints.size(), 0);
    std::vector<int> counts(results.joints.size(), 0);
    for (const PairResult* row : rowsOf(results, method, {})) {
        for (std::size_t j = 0; j < sums.size() && j < row->jointErrorsMm.size(); ++j) {
            if (!std::isnan(row->jointErrorsMm[j])) {
                sums[j] += row->jointErrorsMm[j];
                ++counts[j];
            }
        }
    }
    for (std::size_t j = 0; j < sums.size(); ++j)
        sums[j] = counts[j] > 0 ? sums[j] / counts[j] : std::numeric_limits<double>::quiet_NaN();
    return sums;
}

std::vector<PairResult> worstPairs(const BenchmarkResults& results, const std::string& method, std::size_t count) {
    Rows rows = rowsOf(results, method, {});
    std::stable_sort(rows.begin(), rows.end(),
                     [](const PairResult* a, const PairResult* b) { return a->errorMm > b->errorMm; });
    std::vector<PairResult> worst;
    for (std::size_t i = 0; i < std::min(count, rows.size()); ++i)
        worst.push_back(*rows[i]);
    return worst;
}

} // namespace core
