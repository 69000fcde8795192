// SPDX-License-Identifier: MIT
#include "core/subject/calibration_unit.h"

#include <initializer_list>

namespace core {

namespace {

/// Hands are never this much smaller or larger than a model: the calibration's unit is another one.
constexpr double kLeastRatio = 0.6, kMostRatio = 1.6;

} // namespace

bool isUsualUnit(double mm) {
    return mm == 1 || mm == 10 || mm == 1000;
}

double unitMmOf(double ratio) {
    if (ratio <= 0 || (ratio > kLeastRatio && ratio < kMostRatio))
        return 1;
    for (const double known : {10.0, 1000.0})
        if (ratio * known > 0.75 && ratio * known < 1.33)
            return known;
    return 1 / ratio;
}

} // namespace core
