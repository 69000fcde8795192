// SPDX-License-Identifier: MIT
#include "core/geometry/lens_fold.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace core {

namespace {

constexpr int kMaxSplits = 16;

/// Of a polynomial's Bernstein coefficients on an interval. The polynomial lies within their hull, and is its first and
/// last coefficient at the ends.
bool isPositive(std::vector<double> bernstein, int halvings) {
    if (!(bernstein.front() > 0) || !(bernstein.back() > 0))
        return false;
    bool allPositive = true;
    for (const double b : bernstein)
        allPositive = allPositive && b > 0;
    if (allPositive)
        return true;
    if (halvings == 0)
        return false; // touches zero
    // De Casteljau's construction halves the interval; `bernstein` becomes the right half.
    std::vector<double> left;
    for (std::size_t last = bernstein.size(); last > 0; --last) {
        left.push_back(bernstein.front());
        for (std::size_t i = 0; i + 1 < last; ++i)
            bernstein[i] = (bernstein[i] + bernstein[i + 1]) / 2;
    }
    return isPositive(left, halvings - 1) && isPositive(bernstein, halvings - 1);
}

/// A bound of sum c_i u^i from below for all u in [0, end]: no term is less than at the end, or than 0.
double leastUpTo(double end, std::span<const double> c) {
    double least = c.front(), power = 1;
    for (const double coefficient : c.subspan(1)) {
        power *= end;
        least += std::min(coefficient * power, 0.0);
    }
    return least;
}

/// Whether sum c_i u^i > 0 everywhere in [0, end].
bool isPositiveUpTo(double end, std::span<const double> c) {
    constexpr double kClearly = 0.01; // of slopes that are 1 on the axis
    if (leastUpTo(end, c) > kClearly)
        return true; // almost every point of every lens, without allocating anything
    const std::size_t n = c.size() - 1;
    // b_j = sum_{i <= j} (j choose i) / (n choose i) c_i end^i
    std::vector<double> bernstein(n + 1, 0.0);
    for (std::size_t j = 0; j <= n; ++j) {
        double ratio = 1, power = 1;
        for (std::size_t i = 0; i <= j; ++i) {
            bernstein[j] += ratio * power * c[i];
            ratio *= static_cast<double>(j - i) / static_cast<double>(n - i == 0 ? 1 : n - i);
            power *= end;
        }
    }
    return isPositive(bernstein, kMaxSplits);
}

} // namespace

bool isBeforeFold(const LensCoefficients& lens, bool fisheye, double r2) {
    if (fisheye) {
        const double theta = std::atan(std::sqrt(r2));
        const std::array<double, 5> slope{1, 3 * lens[0], 5 * lens[1], 7 * lens[2], 9 * lens[3]};
        return isPositiveUpTo(theta * theta, slope);
    }
    const auto [k1, k2, p1, p2, k3, k4, k5, k6] = lens;
    const std::array<double, 4> topSlope{1, 3 * k1, 5 * k2, 7 * k3}; // d(r T)/dr by powers of r^2
    if (k4 == 0 && k5 == 0 && k6 == 0)
        return isPositiveUpTo(r2, topSlope);
    // r T / B grows where d(r T)/dr B - r T dB/dr > 0.
    const std::array<double, 4> top{1, k1, k2, k3}, bottom{1, k4, k5, k6}, bottomSlope{0, 2 * k4, 4 * k5, 6 * k6};
    std::array<double, 7> slope{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            slope[i + j] += topSlope[i] * bottom[j] - top[i] * bottomSlope[j];
    return isPositiveUpTo(r2, bottom) && isPositiveUpTo(r2, slope);
}

} // namespace core
