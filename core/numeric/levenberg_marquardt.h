// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/numeric/box_step.h"

namespace core {

/// A nonlinear least-squares problem: cost(x) = 1/2 |r(x)|^2. x may live on a manifold: a step is a tangent vector at
/// x. linearise() gives H = J^T J and g = J^T r, J the derivative of r(retract(x, step)) by the step at 0.
template <typename P>
concept LeastSquaresProblem = requires(const P& problem, const Eigen::VectorXd& x, Eigen::MatrixXd& hessian,
                                       Eigen::VectorXd& gradient) {
    { problem.cost(x) } -> std::convertible_to<double>;
    problem.linearise(x, hessian, gradient);
    { problem.retract(x, x) } -> std::convertible_to<Eigen::VectorXd>;
};

/// How far each entry of a step may go: lower <= step <= upper, lower <= 0 <= upper; infinities allowed.
struct StepBox {
    Eigen::VectorXd lower, upper;
};

/// A problem that also bounds its steps.
template <typename P>
concept BoxedProblem = LeastSquaresProblem<P> && requires(const P& problem, const Eigen::VectorXd& x) {
    { problem.stepBox(x) } -> std::convertible_to<StepBox>;
};

struct SolverOptions {
    int maxIterations = 50;
    /// Converged when max_k |step_k| < minStep, whether or not the step was taken.
    double minStep = 1e-9;
    /// Damping mu of (H + mu diag(H) + diagonalFloor I) step = -g: divided by 10 after a step that was taken, but never
    /// below minDamping; multiplied by 10 after one that was not.
    double initialDamping = 1e-4;
    double minDamping = 1e-9;
    /// Keeps the system regular where nothing depends on an unknown.
    double diagonalFloor = 1e-12;
};

enum class SolverTermination {
    Converged,     ///< the last step was smaller than minStep
    MaxIterations, ///< maxIterations steps were tried
    NotFinite      ///< the cost at the start is not a finite number: nothing was tried
};

/// One iteration, before its step.
struct SolverIteration {
    int iteration = 0;
    double cost = 0;
    double damping = 0;
    double largestStep = 0; ///< max_k |step_k|
    bool taken = false;     ///< the step did not raise the cost
};

struct SolverSummary {
    SolverTermination termination = SolverTermination::MaxIterations;
    double cost = 0; ///< at the end
    std::vector<SolverIteration> history;
};

/// The step that minimises the damped linearised problem, within its box if it has one.
template <LeastSquaresProblem P>
Eigen::VectorXd dampedStep(const P& problem, const Eigen::VectorXd& x, const Eigen::MatrixXd& damped,
                           const Eigen::VectorXd& gradient) {
    if constexpr (BoxedProblem<P>) {
        const StepBox box = problem.stepBox(x);
        return boxConstrainedStep(damped, gradient, box.lower, box.upper);
    } else {
        return -damped.ldlt().solve(gradient);
    }
}

/// Minimises the problem's cost from x on (Levenberg 1944, Marquardt 1963, with Marquardt's scaling of the damping by
/// diag(H)). A step is taken only if the cost does not rise, so x never gets worse.
template <LeastSquaresProblem P>
SolverSummary levenbergMarquardt(const P& problem, const SolverOptions& options, Eigen::VectorXd& x) {
    SolverSummary summary;
    summary.cost = problem.cost(x);
    if (!std::isfinite(summary.cost)) {
        summary.termination = SolverTermination::NotFinite;
        return summary;
    }
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
    double damping = options.initialDamping;
    for (int i = 0; i < options.maxIterations; ++i) {
        problem.linearise(x, hessian, gradient);
        hessian.diagonal() *= 1 + damping;
        hessian.diagonal().array() += options.diagonalFloor;
        const Eigen::VectorXd step = dampedStep(problem, x, hessian, gradient);
        const Eigen::VectorXd candidate = problem.retract(x, step);
        const double candidateCost = problem.cost(candidate);
        const bool taken = candidateCost <= summary.cost;
        summary.history.push_back({i, summary.cost, damping, step.cwiseAbs().maxCoeff(), taken});
        if (taken) {
            x = candidate;
            summary.cost = candidateCost;
            damping = std::max(options.minDamping, damping / 10);
        } else {
            damping *= 10;
        }
        if (summary.history.back().largestStep < options.minStep) {
            summary.termination = SolverTermination::Converged;
            break;
        }
    }
    return summary;
}

} // namespace core
