// SPDX-License-Identifier: MIT
#include "core/numeric/levenberg_marquardt.h"

#include <limits>

#include <ceres/ceres.h>

#include "tests/support/problem_checks.h"
#include "tests/support/random_values.h"

namespace {

using core::SolverOptions;
using core::SolverSummary;
using core::SolverTermination;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Rosenbrock's valley, r = (10 (y - x^2), 1 - x): the minimum 0 at (1, 1).
struct Rosenbrock {
    static Vector2d residuals(const VectorXd& x) { return {10 * (x[1] - x[0] * x[0]), 1 - x[0]}; }

    double cost(const VectorXd& x) const { return 0.5 * residuals(x).squaredNorm(); }
    void linearise(const VectorXd& x, Eigen::MatrixXd& hessian, VectorXd& gradient) const {
        Eigen::Matrix2d jacobian;
        jacobian << -20 * x[0], 10, -1, 0;
        hessian = jacobian.transpose() * jacobian;
        gradient = jacobian.transpose() * residuals(x);
    }
    VectorXd retract(const VectorXd& x, const VectorXd& step) const { return x + step; }
};

/// The same with x and y within [low, high].
struct BoundedRosenbrock : Rosenbrock {
    Vector2d low, high;
    BoundedRosenbrock(const Vector2d& lowest, const Vector2d& highest)
        : low(lowest)
        , high(highest) {}
    core::StepBox stepBox(const VectorXd& x) const { return {low - x, high - x}; }
};

static_assert(core::LeastSquaresProblem<Rosenbrock> && !core::BoxedProblem<Rosenbrock>);
static_assert(core::BoxedProblem<BoundedRosenbrock>);

struct CeresRosenbrock {
    template <typename T>
    bool operator()(const T* x, T* residual) const {
        residual[0] = 10.0 * (x[1] - x[0] * x[0]);
        residual[1] = 1.0 - x[0];
        return true;
    }
};

Vector2d ceresMinimum(Vector2d x, const Vector2d& low, const Vector2d& high) {
    ceres::Problem problem;
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<CeresRosenbrock, 2, 2>(new CeresRosenbrock), nullptr,
                             x.data());
    for (int k = 0; k < 2; ++k) {
        problem.SetParameterLowerBound(x.data(), k, low[k]);
        problem.SetParameterUpperBound(x.data(), k, high[k]);
    }
    ceres::Solver::Options options;
    options.max_num_iterations = 500;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 1e-15;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return x;
}

SolverOptions manyIterations() {
    SolverOptions options;
    options.maxIterations = 500;
    return options;
}

TEST(LevenbergMarquardt, FindsTheEndOfRosenbrocksValley) {
    test::RandomValues random("rosenbrock");
    for (int trial = 0; trial < 20; ++trial) {
        VectorXd x = random.vector(2, 3);
        const SolverSummary summary = core::levenbergMarquardt(Rosenbrock{}, manyIterations(), x);
        EXPECT_EQ(summary.termination, SolverTermination::Converged);
        EXPECT_LT((x - Vector2d(1, 1)).norm(), 1e-7);
        EXPECT_LT(summary.cost, 1e-14);
    }
}

TEST(LevenbergMarquardt, FindsTheMinimumOfCeres) {
    VectorXd x = Vector2d(-1.2, 1);
    const Vector2d peer = ceresMinimum(x, Vector2d::Constant(-10), Vector2d::Constant(10));
    core::levenbergMarquardt(Rosenbrock{}, manyIterations(), x);
    EXPECT_LT((x - peer).norm(), 1e-6);
}

TEST(LevenbergMarquardt, EndsInAMinimumWithinBoundsThatIsNoWorseThanThatOfCeres) {
    test::RandomValues random("bounded rosenbrock");
    for (int trial = 0; trial < 20; ++trial) {
        const Vector2d low(random.between(-2, 0), random.between(-2, 0));
        const Vector2d high(random.between(0.1, 0.9), random.between(0.1, 2));
        VectorXd x = low + (high - low).cwiseProduct(Vector2d(random.between(0, 1), random.between(0, 1)));
        const Vector2d peer = ceresMinimum(x, low, high);
        const SolverSummary summary = core::levenbergMarquardt(BoundedRosenbrock(low, high), manyIterations(), x);
        EXPECT_LE(summary.cost, Rosenbrock{}.cost(peer) + 1e-9) << "trial " << trial;
        // Karush, Kuhn and Tucker: the gradient is zero, or at a bound points out of the box downhill.
        Eigen::MatrixXd hessian;
        VectorXd gradient;
        Rosenbrock{}.linearise(x, hessian, gradient);
        for (int k = 0; k < 2; ++k) {
            EXPECT_TRUE(x[k] >= low[k] - 1e-12 && x[k] <= high[k] + 1e-12);
            const bool atLow = x[k]<low[k] + 1e-9, atHigh = x[k]> high[k] - 1e-9;
            EXPECT_TRUE((atLow && gradient[k] > 0) || (atHigh && gradient[k] < 0) || std::abs(gradient[k]) < 1e-5)
                << "trial " << trial << ": " << x.transpose() << ", gradient " << gradient.transpose();
        }
    }
}

TEST(LevenbergMarquardt, HistoryHasCostsThatNeverRiseAndTheDampingOfEveryStep) {
    VectorXd x = Vector2d(-1.2, 1);
    const SolverSummary summary = core::levenbergMarquardt(Rosenbrock{}, manyIterations(), x);
    const auto& history = summary.history;
    ASSERT_GT(history.size(), 5u);
    EXPECT_DOUBLE_EQ(history[0].cost, Rosenbrock{}.cost(Vector2d(-1.2, 1)));
    int refused = 0;
    for (std::size_t i = 0; i + 1 < history.size(); ++i) {
        EXPECT_EQ(history[i].iteration, static_cast<int>(i));
        EXPECT_LE(history[i + 1].cost, history[i].cost);
        const double expected = history[i].taken ? std::max(1e-9, history[i].damping / 10) : history[i].damping * 10;
        EXPECT_EQ(history[i + 1].damping, expected);
        if (!history[i].taken) {
            EXPECT_EQ(history[i + 1].cost, history[i].cost);
            ++refused;
        }
    }
    EXPECT_GT(refused, 0) << "this start is known for steps that overshoot";
    EXPECT_LT(history.back().largestStep, 1e-9);
}

TEST(LevenbergMarquardt, EndsAtTheIterationLimit) {
    VectorXd x = Vector2d(-1.2, 1);
    SolverOptions options;
    options.maxIterations = 3;
    const SolverSummary summary = core::levenbergMarquardt(Rosenbrock{}, options, x);
    EXPECT_EQ(summary.termination, SolverTermination::MaxIterations);
    EXPECT_EQ(summary.history.size(), 3u);
    EXPECT_DOUBLE_EQ(summary.cost, Rosenbrock{}.cost(x));
}

TEST(LevenbergMarquardt, LeavesAStartWithoutAFiniteCostAlone) {
    VectorXd x = Vector2d(std::numeric_limits<double>::quiet_NaN(), 1);
    const SolverSummary summary = core::levenbergMarquardt(Rosenbrock{}, {}, x);
    EXPECT_EQ(summary.termination, SolverTermination::NotFinite);
    EXPECT_TRUE(summary.history.empty());
    EXPECT_EQ(x[1], 1);
}

TEST(LevenbergMarquardt, RosenbrocksGradientIsThatOfFiniteDifferences) {
    test::expectGradient(Rosenbrock{}, Vector2d(-1.2, 1), 1e-7);
}

} // namespace
