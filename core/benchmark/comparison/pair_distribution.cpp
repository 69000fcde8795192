// SPDX-License-Identifier: MIT
#include "core/benchmark/comparison/pair_distribution.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// The values in their order, without gaps.
std::vector<double> sortedValues(std::vector<double> values) {
    std::erase_if(values, [](double value) { return std::isnan(value); });
    std::sort(values.begin(), values.end());
    return values;
}

/// `values` are sorted and not empty.
double quantile(const std::vector<double>& values, double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double roundWidth(double width) {
    const double power = std::pow(10, std::floor(std::log10(width)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (width <= factor * power * (1 + 1e-9))
            return factor * power;
    return 10 * power;
}

} // namespace

Histogram roundHistogram(const std::vector<double>& values, std::size_t most) {
    constexpr double kTail = 0.01;
    Histogram histogram;
    const std::vector<double> sorted = sortedValues(values);
    if (sorted.empty())
        return histogram;
    const double low = std::min(0.0, quantile(sorted, kTail)), high = std::max(0.0, quantile(sorted, 1 - kTail));
    if (high > low)
        histogram.width = roundWidth((high - low) / static_cast<double>(std::max<std::size_t>(2, most)));
    const double first = std::floor(low / histogram.width + 1e-9), last = std::floor(high / histogram.width + 1e-9);
    histogram.from = first * histogram.width;
    histogram.counts.assign(static_cast<std::size_t>(last - first) + 1, 0);
    for (const double value : sorted) {
        const double bin = std::floor((value - histogram.from) / histogram.width + 1e-9);
        const double within = std::clamp(bin, 0.0, static_cast<double>(histogram.counts.size() - 1));
        ++histogram.counts[static_cast<std::size_t>(within)];
    }
    return histogram;
}

BoxStatistics boxStatistics(std::vector<double> values) {
    const std::vector<double> sorted = sortedValues(std::move(values));
    if (sorted.empty())
        return {};
    return {sorted.size(),         quantile(sorted, 0.05), quantile(sorted, 0.25),
            quantile(sorted, 0.5), quantile(sorted, 0.75), quantile(sorted, 0.95)};
}

} // namespace core
