// SPDX-License-Identifier: MIT
#include "core/numeric/box_step.h"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "tests/support/random_values.h"

namespace {

using core::boxConstrainedStep;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct BoxProblem {
    MatrixXd hessian;
    VectorXd gradient, lower, upper;

    double boxCost(const VectorXd& step) const { return 0.5 * step.dot(hessian * step) + gradient.dot(step); }
};

/// Of `size` unknowns, J^T J of `rows` random rows: the fewer rows, the worse conditioned.
BoxProblem randomProblem(test::RandomValues& random, Eigen::Index size, Eigen::Index rows) {
    MatrixXd jacobian(rows, size);
    for (Eigen::Index k = 0; k < size; ++k)
        jacobian.col(k) = random.vector(rows, 1) * std::pow(10, random.between(-1, 1));
    BoxProblem problem;
    problem.hessian = jacobian.transpose() * jacobian;
    problem.hessian.diagonal() *= 1.001;
    problem.gradient = jacobian.transpose() * random.vector(rows, 1);
    problem.lower = -(random.vector(size, 0.15).array() + 0.15);
    problem.upper = random.vector(size, 0.15).array() + 0.15;
    return problem;
}

/// The best of all 3^n choices of which unknowns are free, at their lower or at their upper bound.
VectorXd bruteForce(const BoxProblem& problem) {
    const Eigen::Index n = problem.gradient.size();
    const int choices = static_cast<int>(std::lround(std::pow(3, n)));
    VectorXd best;
    for (int choice = 0; choice < choices; ++choice) {
        std::vector<Eigen::Index> free;
        VectorXd step = VectorXd::Zero(n);
        int rest = choice;
        bool possible = true;
        for (Eigen::Index k = 0; k < n; ++k, rest /= 3) {
            if (rest % 3 == 0) {
                free.push_back(k);
            } else {
                step[k] = rest % 3 == 1 ? problem.lower[k] : problem.upper[k];
                possible = possible && std::isfinite(step[k]);
            }
        }
        if (!possible)
            continue;
        if (!free.empty()) {
            const VectorXd right = -(problem.gradient + problem.hessian * step);
            const MatrixXd reduced = problem.hessian(free, free);
            step(free) = reduced.ldlt().solve(right(free)).eval();
        }
        const bool inside = (step.array() >= problem.lower.array() - 1e-12).all() &&
                            (step.array() <= problem.upper.array() + 1e-12).all();
        if (inside && (best.size() == 0 || problem.boxCost(step) < problem.boxCost(best)))
            best = step;
    }
    return best;
}

/// The conditions of Karush, Kuhn and Tucker: inside the box, no slope where free, slopes at bounds point out of the
/// box.
void expectOptimal(const BoxProblem& problem, const VectorXd& step) {
    const VectorXd slope = problem.gradient + problem.hessian * step;
    const double small = 1e-8 * (1 + problem.gradient.cwiseAbs().maxCoeff());
    for (Eigen::Index k = 0; k < step.size(); ++k) {
        EXPECT_GE(step[k], problem.lower[k]);
        EXPECT_LE(step[k], problem.upper[k]);
        if (step[k] > problem.lower[k] && problem.lower[k] < problem.upper[k])
            EXPECT_LE(slope[k], small) << "unknown " << k << " should decrease";
        if (step[k] < problem.upper[k] && problem.lower[k] < problem.upper[k])
            EXPECT_GE(slope[k], -small) << "unknown " << k << " should increase";
    }
}

TEST(BoxConstrainedStep, WithoutBoundsIsNewtonsStep) {
    test::RandomValues random("newton");
    BoxProblem problem = randomProblem(random, 20, 60);
    problem.lower.setConstant(-kInfinity);
    problem.upper.setConstant(kInfinity);
    const VectorXd step = boxConstrainedStep(problem.hessian, problem.gradient, problem.lower, problem.upper);
    EXPECT_TRUE(step.isApprox(-problem.hessian.ldlt().solve(problem.gradient), 1e-10));
}

TEST(BoxConstrainedStep, IsTheBestOfAllActiveSets) {
    test::RandomValues random("active sets");
    int bound = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Eigen::Index size = 1 + trial % 6;
        BoxProblem problem = randomProblem(random, size, size + random.below(4));
        if (trial % 3 == 0) {
            problem.lower[random.below(static_cast<int>(size))] = -kInfinity;
            problem.upper[random.below(static_cast<int>(size))] = kInfinity;
        }
        const VectorXd oracle = bruteForce(problem);
        const VectorXd step = boxConstrainedStep(problem.hessian, problem.gradient, problem.lower, problem.upper);
        ASSERT_EQ(oracle.size(), size);
        EXPECT_LT((step - oracle).cwiseAbs().maxCoeff(), 1e-7)
            << "trial " << trial << ": " << step.transpose() << " instead of " << oracle.transpose();
        bound +=
            static_cast<int>((step.array() == problem.lower.array() || step.array() == problem.upper.array()).count());
    }
    EXPECT_GT(bound, 200) << "the problems should be bounded ones";
}

TEST(BoxConstrainedStep, MeetsTheOptimalityConditionsForAWholeHand) {
    test::RandomValues random("whole hand");
    for (int trial = 0; trial < 150; ++trial) {
        const Eigen::Index size = 30 + trial % 11;
        const BoxProblem problem = randomProblem(random, size, size + 5 * (trial % 5));
        expectOptimal(problem, boxConstrainedStep(problem.hessian, problem.gradient, problem.lower, problem.upper));
        if (HasFailure())
            FAIL() << "trial " << trial;
    }
}

TEST(BoxConstrainedStep, HeldUnknownsStayAndTheOthersTakeThemIntoAccount) {
    test::RandomValues random("held");
    BoxProblem problem = randomProblem(random, 12, 40);
    for (const Eigen::Index k : {2, 7})
        problem.lower[k] = problem.upper[k] = 0;
    const VectorXd step = boxConstrainedStep(problem.hessian, problem.gradient, problem.lower, problem.upper);
    EXPECT_EQ(step[2], 0);
    EXPECT_EQ(step[7], 0);
    expectOptimal(problem, step);
}

TEST(BoxConstrainedStep, StaysAtABoundThatItIsPushedAgainst) {
    // A joint at its limit: the lower bound of its step is 0.
    const MatrixXd hessian = (MatrixXd(2, 2) << 2, 1, 1, 2).finished();
    const VectorXd gradient = (VectorXd(2) << 1, -1).finished();
    const VectorXd step = boxConstrainedStep(hessian, gradient, VectorXd::Constant(2, 0), VectorXd::Constant(2, 5));
    EXPECT_DOUBLE_EQ(step[0], 0);
    EXPECT_DOUBLE_EQ(step[1], 0.5); // of the second alone: 1 / 2
}

} // namespace
