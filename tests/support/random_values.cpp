// SPDX-License-Identifier: MIT
#include "tests/support/random_values.h"

#include <cmath>
#include <numbers>

namespace test {

double RandomValues::normal() {
    const double radius = std::sqrt(-2 * std::log(1 - m_random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * m_random.uniform());
}

Eigen::VectorXd RandomValues::vector(Eigen::Index size, double half) {
    Eigen::VectorXd v(size);
    for (Eigen::Index k = 0; k < size; ++k)
        v[k] = between(-half, half);
    return v;
}

Eigen::Vector3d RandomValues::point(double half) {
    return vector(3, half);
}

Eigen::Vector3d RandomValues::direction() {
    Eigen::Vector3d v;
    do {
        v = point(1);
    } while (v.squaredNorm() > 1 || v.squaredNorm() < 1e-4);
    return v.normalized();
}

} // namespace test
