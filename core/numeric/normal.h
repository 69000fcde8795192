// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "core/numeric/random.h"

namespace core {

/// A standard normal number (Box and Muller 1958); draws two uniform ones.
inline double standardNormal(RandomGenerator& random) {
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

} // namespace core
