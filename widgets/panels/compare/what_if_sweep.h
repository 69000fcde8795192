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
/// Whether it is of the pair, and so of all methods.
bool isOfPair(const std::string& key);

/// Which parameter a sweep of that method goes over where none was touched: the first number among its options, or the
/// noise of the outlines.
std::string usualSweep(const core::Method& method);
/// A row of values over which a parameter is worth looking at, in rising order; flags and choices are 0 and 1. Empty
/// for an unknown one.
std::vector<double> sweepValues(const std::string& key, std::size_t cameraCount);
/// The method with another value of an option; empty if it has no such option.
std::string withValue(const std::string& method, const std::string& key, double value);
/// The method with the usual value of an option: what methods have in common that differ in it alone.
std::string withoutOption(const std::string& method, const std::string& key);
/// What an option is in a method, with the method's own defaults; NaN without that option, or without a gate.
double optionValue(const core::Method& method, const std::string& key);
/// Whether both are the same method with the same settings, however they are written.
bool isSameMethod(const std::string& a, const std::string& b);
/// The real-time variant with the same settings; of a method that has none, that of `best`. From one start: others take
/// many times longer, and the method itself looks at them afterwards.
std::string liveVariant(const std::string& method);
/// `count` of `all` cameras, spread evenly over their order.
std::vector<bool> spreadCameras(std::size_t count, std::size_t all);

} // namespace widgets
