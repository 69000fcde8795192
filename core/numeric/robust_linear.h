// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace core {

struct RobustLinearOptions {
    double measurementsPerSample = 1; ///< neighbours that count as one independent measurement
    double leastSigma = 0;            ///< of a measurement; the robust scale is taken to be at least so much
    int rounds = 3;                   ///< of reweighting
};

/// The x that minimises sum_i w_i (r_i + rows_i x)^2 / (sigma^2 k) + x^T priors x, k = measurementsPerSample: sigma is
/// 1.4826 times the median of what is left, w_i = 1 / (1 + (left_i / 2 sigma)^2), both found anew in each round.
/// rows: measurements x unknowns; priors: unknowns x unknowns, positive definite.
Eigen::VectorXd robustLinearSolution(const Eigen::MatrixXd& rows, const Eigen::VectorXd& residuals,
                                     const Eigen::MatrixXd& priors, const RobustLinearOptions& options);

} // namespace core
