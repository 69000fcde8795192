// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace core {

/// k1 k2 p1 p2 k3 k4 k5 k6 of the rational model, or the four of the fisheye model; zeros behind.
using LensCoefficients = std::array<double, 8>;

/// True if the radial map r -> r_d of a lens grows all the way from the axis to the normalised radius whose square is
/// `r2`. A lens model with, say, k1 = -0.96 turns back within the image: beyond that radius it would show points that
/// are farther out nearer to the middle, mirrored. Exact, by the signs of the derivative's Bernstein coefficients.
bool isBeforeFold(const LensCoefficients& lens, bool fisheye, double r2);

} // namespace core
