// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace core {

/// The step s that minimises 1/2 s^T H s + g^T s with lower <= s <= upper (component-wise; infinities allowed, lower <= 0
/// <= upper). H must be symmetric positive definite. Active-set method: exact for the few dozen unknowns of a hand.
Eigen::VectorXd boxConstrainedStep(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

} // namespace core
