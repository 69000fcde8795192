// SPDX-License-Identifier: MIT
#include "core/numeric/robust_linear.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "core/numeric/median.h"

namespace core {

Eigen::VectorXd robustLinearSolution(const Eigen::MatrixXd& rows, const Eigen::VectorXd& residuals,
                                     const Eigen::MatrixXd& priors, const RobustLinearOptions& options) {
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(rows.cols());
    for (int round = 0; round < options.rounds; ++round) {
        const Eigen::VectorXd left = residuals + rows * solution;
        std::vector<double> sizes;
        for (Eigen::Index i = 0; i < left.size(); ++i)
            sizes.push_back(std::abs(left[i]));
        const double sigma = std::max(options.leastSigma, sizes.empty() ? 0 : kSigmaPerMedian * medianOf(sizes));
        if (sigma <= 0)
            return solution;
        const double information = 1 / (sigma * sigma * options.measurementsPerSample);
        const Eigen::VectorXd weights = information / (1 + (left / (2 * sigma)).array().square());
        const Eigen::MatrixXd weighted = weights.asDiagonal() * rows;
        solution = -(rows.transpose() * weighted + priors).ldlt().solve(weighted.transpose() * residuals);
    }
    return solution;
}

} // namespace core
