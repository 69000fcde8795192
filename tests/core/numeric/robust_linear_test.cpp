// SPDX-License-Identifier: MIT
#include "core/numeric/robust_linear.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace {

constexpr int kRows = 400, kUnknowns = 4;

struct Measured {
    Eigen::MatrixXd rows;
    Eigen::VectorXd truth, residuals;
};

/// residuals + rows truth = noise.
Measured measured(double sigma) {
    std::mt19937 generator(3);
    std::normal_distribution<double> normal;
    Measured m;
    m.rows = Eigen::MatrixXd::NullaryExpr(kRows, kUnknowns, [&] { return normal(generator); });
    m.truth = Eigen::Vector4d(1, -2, 0.5, 3);
    m.residuals = -m.rows * m.truth + Eigen::VectorXd::NullaryExpr(kRows, [&] { return sigma * normal(generator); });
    return m;
}

TEST(RobustLinear, AFifthOfWrongMeasurementsHardlyMovesTheSolution) {
    Measured m = measured(0.1);
    for (int i = 0; i < kRows; i += 5)
        m.residuals[i] += 20;
    const Eigen::MatrixXd priors = 1e-6 * Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
    const Eigen::VectorXd robust = core::robustLinearSolution(m.rows, m.residuals, priors, {.rounds = 6});
    EXPECT_LT((robust - m.truth).norm(), 0.05);
    const Eigen::VectorXd plain = -m.rows.colPivHouseholderQr().solve(m.residuals);
    EXPECT_GT((plain - m.truth).norm(), 5 * (robust - m.truth).norm());
}

TEST(RobustLinear, APriorCountsMoreWhereMeasurementsRepeatEachOther) {
    const Measured m = measured(1);
    const Eigen::MatrixXd priors = Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
    const Eigen::VectorXd single = core::robustLinearSolution(m.rows, m.residuals, priors, {});
    const Eigen::VectorXd repeated =
        core::robustLinearSolution(m.rows, m.residuals, priors, {.measurementsPerSample = 400});
    EXPECT_LT((single - m.truth).norm(), 0.2);
    EXPECT_LT(repeated.norm(), 0.7 * single.norm());
}

TEST(RobustLinear, WithoutMeasurementsThePriorAloneDecides) {
    const Eigen::MatrixXd priors = Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
    EXPECT_EQ(core::robustLinearSolution(Eigen::MatrixXd(0, kUnknowns), Eigen::VectorXd(0), priors, {}).norm(), 0);
}

} // namespace
