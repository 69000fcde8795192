// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace core {

/// The mean; 0 of no values.
double meanOf(const std::vector<double>& values);
/// The median; of an even number of values, the mean of the two in the middle. At least one value, none of them NaN.
double medianOf(std::vector<double> values);

/// The standard deviation of a normal distribution per median of its absolute values.
inline constexpr double kSigmaPerMedian = 1.4826;
/// The median of chi-square with two degrees of freedom, 2 ln 2: sigma^2 of pixels is the median of r^2 over it.
inline constexpr double kMedianOfChiSquare2 = 1.3862943611198906;

} // namespace core
