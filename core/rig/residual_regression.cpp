// SPDX-License-Identifier: MIT
#include "core/rig/residual_regression.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "core/numeric/median.h"

namespace core {

std::optional<Regression> regress(const Eigen::MatrixXd& design, const Eigen::VectorXd& residuals) {
    const Eigen::Index clicks = residuals.size() / 2;
    Regression fit;
    fit.weights = Eigen::VectorXd::Ones(residuals.size());
    const double share = std::max(0.1, 1 - static_cast<double>(design.cols()) / static_cast<double>(residuals.size()));
    std::vector<double> squares(static_cast<std::size_t>(clicks));
    constexpr int kMaxRounds = 20;
    for (int round = 0; round < kMaxRounds; ++round) {
        const Eigen::MatrixXd weighted = fit.weights.asDiagonal() * design;
        const Eigen::LDLT<Eigen::MatrixXd> solver(weighted.transpose() * design);
        if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-10))
            return std::nullopt;
        const Eigen::VectorXd before = fit.unknowns;
        fit.unknowns = solver.solve(weighted.transpose() * residuals);
        fit.rest = residuals - design * fit.unknowns;
        for (Eigen::Index i = 0; i < clicks; ++i)
            squares[static_cast<std::size_t>(i)] = fit.rest.segment<2>(2 * i).squaredNorm();
        fit.scatterPx = std::max(0.01, std::sqrt(medianOf(squares) / kMedianOfChiSquare2 / share));
        const double variance = fit.scatterPx * fit.scatterPx;
        for (Eigen::Index i = 0; i < clicks; ++i) {
            const double ratio = squares[static_cast<std::size_t>(i)] / (9 * variance);
            fit.weights.segment<2>(2 * i).setConstant(1 / (1 + ratio * ratio));
        }
        fit.covariance = variance * solver.solve(Eigen::MatrixXd::Identity(design.cols(), design.cols()));
        constexpr double kSettled = 1e-3; // of a standard deviation
        if (round > 0 &&
            ((fit.unknowns - before).array().abs() < kSettled * fit.covariance.diagonal().array().sqrt()).all())
            break;
    }
    return fit;
}

} // namespace core
