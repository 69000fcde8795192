// SPDX-License-Identifier: MIT
#include "core/io/footage/frame_times.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr double kRoundingSec = 0.00101; ///< containers that keep milliseconds
constexpr double kJitter = 0.3;          ///< of a step
constexpr double kSaneShare = 0.8;       ///< of the steps are equal
constexpr std::size_t kAround = 3;       ///< frames on each side that tell a gap from jitter
constexpr double kMostLost = 1e7;        ///< frames in all gaps: days; more is a clock that was set

std::vector<double> stepsOf(const std::vector<double>& timesSec) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < timesSec.size(); ++i)
        steps.push_back(timesSec[i] - timesSec[i - 1]);
    return steps;
}

bool isUsual(double step, double usual) {
    return std::abs(step - usual) <= std::max(kJitter * usual, kRoundingSec);
}

/// The mean of the steps that are about the median: as exact as rounded stamps allow.
double usualStep(const std::vector<double>& steps) {
    std::vector<double> sorted = steps;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double median = *middle;
    double sum = 0;
    int count = 0;
    for (const double step : steps) {
        if (isUsual(step, median)) {
            sum += step;
            ++count;
        }
    }
    return sum / count; // the median itself counts
}

/// Frames lost between i - 1 and i: how much later, in whole steps, the frames from i on are than those before.
double lostBefore(std::size_t i, const std::vector<double>& timesSec, double stepSec) {
    const auto lag = [&](std::size_t j) {
        return (timesSec[j] - timesSec[i - 1]) / stepSec - (static_cast<double>(j) - static_cast<double>(i - 1));
    };
    double before = 0, after = lag(i);
    for (std::size_t j = i > kAround ? i - kAround : 0; j < i; ++j)
        before = std::max(before, lag(j));
    for (std::size_t j = i; j < std::min(i + kAround + 1, timesSec.size()); ++j)
        after = std::min(after, lag(j));
    return std::round(after - before);
}

} // namespace

FrameTiming analyseTimes(const std::vector<double>& timesSec) {
    FrameTiming timing;
    const std::vector<double> steps = stepsOf(timesSec);
    if (steps.empty())
        return timing;
    timing.stepSec = usualStep(steps);
    const auto usual = std::count_if(
        steps.begin(), steps.end(), [&](double step) { return isUsual(step, timing.stepSec); });
    const bool increases = std::all_of(steps.begin(), steps.end(), [](double step) { return step > 0; });
    timing.isSane = increases && static_cast<double>(usual) >= kSaneShare * static_cast<double>(steps.size());
    if (!timing.isSane)
        return timing;
    double allLost = 0;
    for (std::size_t i = 1; i < timesSec.size(); ++i) {
        if (steps[i - 1] <= 1.5 * timing.stepSec)
            continue;
        const double lost = lostBefore(i, timesSec, timing.stepSec);
        if (!(lost > 0))
            continue;
        allLost += lost;
        if (allLost > kMostLost) {
            timing.isSane = false;
            timing.gaps.clear();
            return timing;
        }
        timing.gaps.push_back({static_cast<int>(i) - 1, static_cast<int>(lost)});
    }
    return timing;
}

double roundedRate(double stepSec) {
    if (stepSec <= 0)
        return 0;
    const double rate = 1 / stepSec, whole = std::round(rate), film = std::round(rate * 1.001) / 1.001;
    const double nearest = std::abs(rate - whole) <= std::abs(rate - film) ? whole : film;
    return whole > 0 && std::abs(rate - nearest) < 0.001 * rate ? nearest : rate;
}

} // namespace core
