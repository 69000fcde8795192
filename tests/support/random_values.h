// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

#include <Eigen/Core>

#include "core/numeric/random.h"

namespace test {

/// Random numbers and vectors, seeded by a name: every test draws its own, always and everywhere the same.
class RandomValues {
public:
    explicit RandomValues(std::string_view name)
        : m_random(core::stableHash(name)) {}

    double between(double low, double high) { return low + (high - low) * m_random.uniform(); }
    int below(int bound) { return static_cast<int>(m_random.below(static_cast<std::uint64_t>(bound))); }

    /// Standard normal (Box and Muller 1958).
    double normal() {
        const double radius = std::sqrt(-2 * std::log(1 - m_random.uniform()));
        return radius * std::cos(2 * std::numbers::pi * m_random.uniform());
    }

    /// Every entry in [-half, half).
    Eigen::VectorXd vector(Eigen::Index size, double half) {
        Eigen::VectorXd v(size);
        for (Eigen::Index k = 0; k < size; ++k)
            v[k] = between(-half, half);
        return v;
    }
    Eigen::Vector3d point(double half) { return vector(3, half); }

    /// A unit vector, every direction equally likely.
    Eigen::Vector3d direction() {
        Eigen::Vector3d v;
        do {
            v = point(1);
        } while (v.squaredNorm() > 1 || v.squaredNorm() < 1e-4);
        return v.normalized();
    }

private:
    core::RandomGenerator m_random;
};

} // namespace test
