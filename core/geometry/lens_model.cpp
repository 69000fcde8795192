// SPDX-License-Identifier: MIT
#include "core/geometry/lens_model.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace core {

namespace {

/// OpenCV's rational model: k1 k2 p1 p2 k3 k4 k5 k6.
Eigen::Vector2d distortRational(const LensCoefficients& k, bool isPolynomial, const Eigen::Vector2d& n,
                                Eigen::Matrix2d* jacobian) {
    const auto& [k1, k2, p1, p2, k3, k4, k5, k6] = k;
    const double x = n.x(), y = n.y(), r2 = x * x + y * y;
    const double top = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double bottom = isPolynomial ? 1 : 1 + r2 * (k4 + r2 * (k5 + r2 * k6));
    const double radial = isPolynomial ? top : top / bottom;
    if (jacobian) {
        const double topByR2 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
        const double bottomByR2 = k4 + r2 * (2 * k5 + r2 * 3 * k6);
        const double radialByR2 = isPolynomial ? topByR2 : (topByR2 - radial * bottomByR2) / bottom;
        const double mixed = 2 * x * y * radialByR2;
        *jacobian << radial + 2 * x * x * radialByR2 + 2 * p1 * y + 6 * p2 * x, mixed + 2 * p1 * x + 2 * p2 * y,
            mixed + 2 * p1 * x + 2 * p2 * y, radial + 2 * y * y * radialByR2 + 6 * p1 * y + 2 * p2 * x;
    }
    return {x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x), y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
}

/// OpenCV's fisheye model: theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8).
Eigen::Vector2d distortFisheye(const LensCoefficients& k, const Eigen::Vector2d& n, Eigen::Matrix2d* jacobian) {
    const double r = n.norm();
    if (r < 1e-12) {
        if (jacobian)
            jacobian->setIdentity();
        return n;
    }
    const double theta = std::atan(r), t2 = theta * theta;
    const double thetaD = theta * (1 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
    const double scale = thetaD / r;
    if (jacobian) {
        const double thetaDByTheta = 1 + t2 * (3 * k[0] + t2 * (5 * k[1] + t2 * (7 * k[2] + t2 * 9 * k[3])));
        const double scaleByR = (thetaDByTheta / (1 + r * r) - scale) / r;
        *jacobian = scale * Eigen::Matrix2d::Identity() + (scaleByR / r) * n * n.transpose();
    }
    return scale * n;
}

/// A value that is negative or small where the lens may fold back before the normalised point: with u = r^2, the slope
/// of the radial map, 1 + 3 k1 u + 5 k2 u^2 + 7 k3 u^3, is at least 1 plus its negative terms, on the whole way to the
/// point, and tangential terms change the Jacobian by at most 8 (|p1| + |p2|) r <= 4 (|p1| + |p2|) (1 + u).
double foldMargin(const LensCoefficients& k, double u) {
    const auto loss = [](double term) { return std::min(term, 0.0); };
    return 1 + loss(3 * k[0] * u) + loss(5 * k[1] * u * u) + loss(7 * k[4] * u * u * u) -
           4 * (std::abs(k[2]) + std::abs(k[3])) * (1 + u);
}

} // namespace

LensModel::LensModel(std::span<const double> distortion, bool isFisheye)
    : m_isFisheye(isFisheye) {
    LensCoefficients& k = m_coefficients;
    std::copy_n(distortion.begin(), std::min(k.size(), distortion.size()), k.begin());
    m_isPolynomial = !m_isFisheye && k[5] == 0 && k[6] == 0 && k[7] == 0;
}

Eigen::Vector2d LensModel::distort(const Eigen::Vector2d& normalised, Eigen::Matrix2d* jacobian) const {
    return m_isFisheye ? distortFisheye(m_coefficients, normalised, jacobian)
                       : distortRational(m_coefficients, m_isPolynomial, normalised, jacobian);
}

bool LensModel::holds(const Eigen::Vector2d& normalised) const {
    if (m_isPolynomial && foldMargin(m_coefficients, normalised.squaredNorm()) > 0.01)
        return true; // every ordinary lens
    if (!isBeforeFold(m_coefficients, m_isFisheye, normalised.squaredNorm()))
        return false;
    Eigen::Matrix2d jacobian;
    distort(normalised, &jacobian);
    return jacobian.determinant() > 0;
}

} // namespace core
