// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace core {

/// Circular distance of two angles in rad. Signed ("360"): in [0, pi]; unsigned ("180", a line has no front): in [0, pi/2].
template <typename Real>
Real circularDistance(Real aRad, Real bRad, bool signedOrientation) {
    constexpr Real kPi = std::numbers::pi_v<Real>;
    Real d = std::fmod(std::abs(aRad - bRad), 2 * kPi);
    d = std::min(d, 2 * kPi - d);
    return signedOrientation ? d : std::min(d, kPi - d);
}

/// Equal bins around the circle: bin k is centred on k * width, so bin 0 covers [-width/2, width/2).
/// Signed bins are 2 pi / B wide, unsigned ones pi / B.
struct OrientationBins {
    int count = 16;
    bool signedOrientation = true;

    double period() const { return (signedOrientation ? 2 : 1) * std::numbers::pi; }
    double widthRad() const { return period() / count; }
    double centreRad(int bin) const { return bin * widthRad(); }
    /// The bin whose centre is nearest, in [0, count).
    int bin(double angleRad) const { return wrapped(std::lround(angleRad / widthRad())); }
    /// The two bins with the nearest centres, nearest first (equal only if there is one bin).
    std::array<int, 2> nearestTwo(double angleRad) const {
        const double position = angleRad / widthRad();
        const long nearest = std::lround(position);
        return {wrapped(nearest), wrapped(position >= static_cast<double>(nearest) ? nearest + 1 : nearest - 1)};
    }
    /// Circular distance of two bins' centres, rad.
    double distanceRad(int a, int b) const {
        const int steps = std::abs(a - b);
        return std::min(steps, count - steps) * widthRad();
    }

private:
    int wrapped(long bin) const {
        const long remainder = bin % count;
        return static_cast<int>(remainder < 0 ? remainder + count : remainder);
    }
};

} // namespace core
