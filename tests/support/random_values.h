// SPDX-License-Identifier: MIT
#pragma once

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
    double normal();

    /// Every entry in [-half, half).
    Eigen::VectorXd vector(Eigen::Index size, double half);
    Eigen::Vector3d point(double half);

    /// A unit vector, every direction equally likely.
    Eigen::Vector3d direction();

private:
    core::RandomGenerator m_random;
};

} // namespace test
