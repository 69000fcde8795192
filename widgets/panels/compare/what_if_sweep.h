// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/fitting/method.h"

namespace widgets {

/// What a sweep can go over besides the options of a method: the noise of the outlines (px) and how many cameras take
/// part.
inline constexpr const char* kNoiseKey = "outlines";
inline constexpr const char* kCamerasKey = "cameras";

/// Which parameter a sweep of that method goes over where none was touched: the first number among its options, or the
/// noise of the outlines.
std::string usualSweep(const core::Method& method);
/// A row of values over which a parameter is worth looking at, in rising order; flags and choices are 0 and 1. Empty
/// for an unknown one.
std::vector<double> sweepValues(const std::string& key, std::size_t cameraCount);
/// The method with another value of an option; empty if it has no such option.
std::string withValue(const std::string& method, const std::string& key, double value);
/// `count` of `all` cameras, spread evenly over their order.
std::vector<bool> spreadCameras(std::size_t count, std::size_t all);

} // namespace widgets
