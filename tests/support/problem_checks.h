// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "core/numeric/levenberg_marquardt.h"

namespace test {

/// Central differences of a vector-valued function of x along every tangent direction of the problem: one column each.
template <core::LeastSquaresProblem P, typename Function>
Eigen::MatrixXd numericJacobian(const P& problem, const Eigen::VectorXd& x, Function&& function, double width = 1e-6) {
    const Eigen::Index rows = Eigen::VectorXd(function(x)).size();
    Eigen::MatrixXd jacobian(rows, x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        const Eigen::VectorXd step = width * Eigen::VectorXd::Unit(x.size(), k);
        const Eigen::VectorXd after = function(Eigen::VectorXd(problem.retract(x, step)));
        const Eigen::VectorXd before = function(Eigen::VectorXd(problem.retract(x, -step)));
        jacobian.col(k) = (after - before) / (2 * width);
    }
    return jacobian;
}

/// Compares the problem's gradient with central differences of its cost.
template <core::LeastSquaresProblem P>
void expectGradient(const P& problem, const Eigen::VectorXd& x, double relativeTolerance) {
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
    problem.linearise(x, hessian, gradient);
    const auto cost = [&](const Eigen::VectorXd& at) { return Eigen::VectorXd::Constant(1, problem.cost(at)); };
    const Eigen::VectorXd numeric = numericJacobian(problem, x, cost).transpose();
    EXPECT_LT((gradient - numeric).norm(), relativeTolerance * (1 + numeric.norm())) << gradient.transpose() << "\n"
                                                                                     << numeric.transpose();
}

} // namespace test
