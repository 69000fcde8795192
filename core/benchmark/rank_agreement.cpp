// SPDX-License-Identifier: MIT
#include "core/benchmark/rank_agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/benchmark/metrics.h"
#include "core/numeric/random.h"

namespace core {

namespace {

/// Errors of every method, pair by pair, of the pairs that all methods have.
struct ErrorTable {
    std::vector<FramePair> pairs;
    std::vector<std::vector<double>> errorsMm; ///< [pair][method]
};

ErrorTable tableOf(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::map<FramePair, std::vector<double>> byPair;
    for (const PairResult& row : results.rows) {
        const auto at = std::find(methods.begin(), methods.end(), row.method);
        if (at == methods.end())
            continue;
        auto& errors = byPair[row.pair];
        errors.resize(methods.size(), std::numeric_limits<double>::quiet_NaN());
        errors[static_cast<std::size_t>(at - methods.begin())] = row.errorMm;
    }
    ErrorTable table;
    for (auto& [pair, errors] : byPair) {
        if (std::any_of(errors.begin(), errors.end(), [](double mm) { return std::isnan(mm); }))
            continue;
        table.pairs.push_back(pair);
        table.errorsMm.push_back(errors);
    }
    return table;
}

std::vector<double> meansOf(const ErrorTable& table, const std::vector<std::size_t>& chosen, std::size_t methods) {
    std::vector<double> means(methods, 0);
    for (const std::size_t pair : chosen)
        for (std::size_t m = 0; m < methods; ++m)
            means[m] += table.errorsMm[pair][m] / static_cast<double>(chosen.size());
    return means;
}

std::vector<std::size_t> drawnAgain(std::size_t count, RandomGenerator& random) {
    std::vector<std::size_t> chosen(count);
    for (std::size_t& i : chosen)
        i = static_cast<std::size_t>(random.below(count));
    return chosen;
}

int order(double a, double b, double tie) {
    return std::abs(a - b) <= tie ? 0 : a < b ? -1 : 1;
}

} // namespace

double kendallTau(const std::vector<double>& a, const std::vector<double>& b, double tie) {
    double score = 0, orderedA = 0, orderedB = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = i + 1; j < a.size(); ++j) {
            const int inA = order(a[i], a[j], tie), inB = order(b[i], b[j], tie);
            score += inA * inB;
            orderedA += std::abs(inA);
            orderedB += std::abs(inB);
        }
    }
    return orderedA * orderedB > 0 ? score / std::sqrt(orderedA * orderedB) : std::numeric_limits<double>::quiet_NaN();
}

RankAgreement rankAgreement(const BenchmarkResults& a, const BenchmarkResults& b,
                            const std::vector<std::string>& methods, std::uint64_t seed, int resamples) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    const ErrorTable first = tableOf(a, methods), second = tableOf(b, methods);
    if (first.pairs.empty() || second.pairs.empty())
        return {kNothing, kNothing, kNothing};
    std::vector<std::size_t> allFirst(first.pairs.size()), allSecond(second.pairs.size());
    std::iota(allFirst.begin(), allFirst.end(), 0);
    std::iota(allSecond.begin(), allSecond.end(), 0);
    const auto tauOf = [&](const std::vector<std::size_t>& i, const std::vector<std::size_t>& j) {
        return kendallTau(meansOf(first, i, methods.size()), meansOf(second, j, methods.size()));
    };
    RandomGenerator random(seed);
    std::vector<double> taus;
    for (int k = 0; k < resamples; ++k) {
        const std::vector<std::size_t> i = drawnAgain(first.pairs.size(), random);
        const std::vector<std::size_t> j = first.pairs == second.pairs ? i : drawnAgain(second.pairs.size(), random);
        const double tau = tauOf(i, j);
        if (!std::isnan(tau))
            taus.push_back(tau);
    }
    std::sort(taus.begin(), taus.end());
    const auto percentile = [&](double share) {
        return taus.empty() ? kNothing : taus[static_cast<std::size_t>(share * static_cast<double>(taus.size() - 1))];
    };
    return {tauOf(allFirst, allSecond), percentile(0.025), percentile(0.975)};
}

std::string orderText(const BenchmarkResults& results, const std::vector<std::string>& methods) {
    std::vector<std::pair<double, std::string>> ranked;
    for (const std::string& method : methods) {
        const ErrorStatistics statistics = errorStatistics(results, method);
        if (statistics.pairs > 0)
            ranked.emplace_back(statistics.meanMm, method);
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string text;
    for (const auto& [mm, method] : ranked)
        text += (text.empty() ? "" : " < ") + method;
    return text;
}

} // namespace core
