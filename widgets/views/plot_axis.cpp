// SPDX-License-Identifier: MIT
#include "widgets/views/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace widgets {

namespace {

/// The smallest of 1, 2, 5 times a power of ten that is not smaller than `step`.
double roundStep(double step) {
    const double power = std::pow(10, std::floor(std::log10(step)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (step <= factor * power * (1 + 1e-9))
            return factor * power;
    return 10 * power;
}

/// The multiples of a round step within the axis; it has at most `parts` such steps.
std::vector<double> multiples(const PlotAxis& axis, int parts) {
    double step = roundStep((axis.max - axis.min) / parts);
    if (axis.whole)
        step = std::max(1.0, step);
    std::vector<double> result;
    for (double i = std::ceil(axis.min / step - 1e-9); i * step <= axis.max + 1e-9 * step; ++i)
        result.push_back(i * step);
    return result;
}

/// At least two where a smaller step gives them: nothing can be read off an axis with one number.
std::vector<double> linearTicks(const PlotAxis& axis, int most) {
    constexpr int kSmaller = 3;
    std::vector<double> result = multiples(axis, most - 1);
    for (int parts = most; result.size() < 2 && parts < most + kSmaller; ++parts)
        if (std::vector<double> finer = multiples(axis, parts); static_cast<int>(finer.size()) <= most + 1)
            result = std::move(finer);
    return result;
}

std::vector<double> logarithmicTicks(const PlotAxis& axis, int most) {
    std::vector<double> powers, all;
    for (double e = std::floor(std::log10(axis.min)); e <= std::log10(axis.max) + 1e-9; ++e) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double v = factor * std::pow(10, e);
            if (v >= axis.min * (1 - 1e-9) && v <= axis.max * (1 + 1e-9)) {
                all.push_back(v);
                if (factor == 1)
                    powers.push_back(v);
            }
        }
    }
    return static_cast<int>(all.size()) <= most || powers.size() < 2 ? all : powers;
}

} // namespace

double PlotAxis::position(double v) const {
    if (logarithmic)
        return v > min ? std::log(v / min) / std::log(max / min) : 0;
    return (v - min) / (max - min);
}

double PlotAxis::value(double p) const {
    return logarithmic ? min * std::pow(max / min, p) : min + p * (max - min);
}

PlotAxis roundAxis(double min, double max, bool logarithmic) {
    if (logarithmic) {
        if (!(min > 0) || !(max >= min))
            return {0.1, 1, true};
        const double low = std::pow(10, std::floor(std::log10(min) + 1e-9));
        const double high = std::pow(10, std::ceil(std::log10(max) - 1e-9));
        return {low, high > low ? high : 10 * low, true};
    }
    if (!(max >= min) || !std::isfinite(max - min))
        return {0, 1, false};
    if (min >= 0 && min < 0.4 * max)
        min = 0;
    if (max - min < 1e-12 * std::max(1.0, std::abs(max)))
        max = min + 1;
    constexpr int kSteps = 5;
    const double step = roundStep((max - min) / kSteps);
    return {std::floor(min / step + 1e-9) * step, std::ceil(max / step - 1e-9) * step, false};
}

std::vector<double> ticks(const PlotAxis& axis, int most) {
    return axis.logarithmic ? logarithmicTicks(axis, std::max(2, most)) : linearTicks(axis, std::max(2, most));
}

} // namespace widgets
