// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace core {

/// The median; of an even number of values, the mean of the two in the middle. At least one value, none of them NaN.
double medianOf(std::vector<double> values);

} // namespace core
