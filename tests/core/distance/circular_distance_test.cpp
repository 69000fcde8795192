// SPDX-License-Identifier: MIT
#include "core/distance/circular_distance.h"

#include <complex>

#include <gtest/gtest.h>

namespace core {
namespace {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

TEST(CircularDistance, WrapsAtHalfATurnAndUnsignedAtAQuarter) {
    EXPECT_NEAR(signedCircularDistance(radians(170), radians(-170)), radians(20), 1e-12);
    EXPECT_NEAR(unsignedCircularDistance(radians(170), radians(-170)), radians(20), 1e-12);
    EXPECT_NEAR(signedCircularDistance(0, radians(180)), radians(180), 1e-12);
    EXPECT_NEAR(unsignedCircularDistance(0, radians(180)), 0, 1e-12);
    EXPECT_NEAR(signedCircularDistance(radians(-90), radians(90)), radians(180), 1e-12);
    EXPECT_NEAR(unsignedCircularDistance(radians(10), radians(100)), radians(90), 1e-12);
}

/// Oracle: the angle between unit vectors, which knows nothing of wrapping.
TEST(CircularDistance, IsTheAngleBetweenDirections) {
    for (int a = -720; a <= 720; a += 35) {
        for (int b = -720; b <= 720; b += 25) {
            const std::complex<double> u = std::polar(1.0, radians(a));
            const std::complex<double> v = std::polar(1.0, radians(b));
            const double angle = std::abs(std::arg(u * std::conj(v)));
            EXPECT_NEAR(circularDistance(radians(a), radians(b), true), angle, 1e-7);
            EXPECT_NEAR(circularDistance(radians(a), radians(b), false), std::min(angle, std::numbers::pi - angle),
                        1e-7);
        }
    }
}

} // namespace
} // namespace core
