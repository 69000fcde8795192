// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace core {

/// The step s that minimises 1/2 s^T H s + g^T s with lower <= s <= upper (component-wise; infinities allowed, lower <=
/// 0
/// <= upper). H must be symmetric positive definite. Primal active-set method (Nocedal and Wright 2006, 16.5): exact.
Eigen::VectorXd boxConstrainedStep(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

} // namespace core
