// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <Eigen/Core>

#include "core/geometry/lens_fold.h"

namespace core {

/// A camera's lens with its coefficients read, for many points. distort() and lensHolds() of a camera make one for
/// each point.
class LensModel {
public:
    /// As a Camera has them.
    LensModel(std::span<const double> distortion, bool isFisheye);

    /// Lens distortion of normalised coordinates (x/z, y/z), and its 2x2 Jacobian if asked for.
    Eigen::Vector2d distort(const Eigen::Vector2d& normalised, Eigen::Matrix2d* jacobian = nullptr) const;

    /// False for normalised coordinates beyond the radius at which the model folds back, or where its tangential terms
    /// turn the image over: no pixel shows them.
    bool holds(const Eigen::Vector2d& normalised) const;

private:
    LensCoefficients m_coefficients{};
    bool m_isFisheye;
    bool m_isPolynomial; ///< k1 k2 p1 p2 k3 alone
};

} // namespace core
