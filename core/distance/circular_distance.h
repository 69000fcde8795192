// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace core {

/// Circular distance of two directions, in [0, pi] (circ of Tzionas and Gall 2013 over 360 degrees). Any angles, rad.
inline double signedCircularDistance(double aRad, double bRad) {
    const double difference = std::fmod(std::abs(aRad - bRad), 2 * std::numbers::pi);
    return std::fmin(difference, 2 * std::numbers::pi - difference);
}

/// Circular distance of two undirected lines, in [0, pi/2] (circ over 180 degrees): opposite directions are equal.
inline double unsignedCircularDistance(double aRad, double bRad) {
    const double difference = signedCircularDistance(aRad, bRad);
    return std::fmin(difference, std::numbers::pi - difference);
}

/// One of the two above.
inline double circularDistance(double aRad, double bRad, bool isSigned) {
    return isSigned ? signedCircularDistance(aRad, bRad) : unsignedCircularDistance(aRad, bRad);
}

} // namespace core
