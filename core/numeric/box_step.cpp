// SPDX-License-Identifier: MIT
#include "core/numeric/box_step.h"

#include <vector>

#include <Eigen/Cholesky>

namespace core {

namespace {

enum class Bound { Free, Lower, Upper };

/// Solves for the free unknowns with the bound ones held at their bounds.
void solveFree(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient, const std::vector<Bound>& bounds,
               Eigen::VectorXd& step) {
    std::vector<Eigen::Index> free;
    Eigen::VectorXd held = step;
    for (Eigen::Index k = 0; k < step.size(); ++k) {
        if (bounds[static_cast<std::size_t>(k)] == Bound::Free) {
            free.push_back(k);
            held[k] = 0;
        }
    }
    if (free.empty()) {
        return;
    }
    const Eigen::VectorXd right = gradient + hessian * held;
    const Eigen::MatrixXd reduced = hessian(free, free);
    const Eigen::VectorXd solved = reduced.llt().solve(-right(free));
    step(free) = solved;
}

} // namespace

Eigen::VectorXd boxConstrainedStep(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
    const Eigen::Index n = gradient.size();
    std::vector<Bound> bounds(static_cast<std::size_t>(n), Bound::Free);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(n);
    constexpr int kMaxRounds = 30;
    for (int round = 0; round < kMaxRounds; ++round) {
        solveFree(hessian, gradient, bounds, step);
        bool changed = false;
        for (Eigen::Index k = 0; k < n; ++k) {
            Bound& bound = bounds[static_cast<std::size_t>(k)];
            if (bound == Bound::Free && (step[k] < lower[k] || step[k] > upper[k])) {
                bound = step[k] < lower[k] ? Bound::Lower : Bound::Upper;
                step[k] = bound == Bound::Lower ? lower[k] : upper[k];
                changed = true;
            }
        }
        if (changed) {
            continue;
        }
        // Release the bound that the model pulls away from most.
        const Eigen::VectorXd slope = gradient + hessian * step;
        Eigen::Index release = -1;
        double strongest = 1e-12 * (1 + gradient.cwiseAbs().maxCoeff());
        for (Eigen::Index k = 0; k < n; ++k) {
            const Bound bound = bounds[static_cast<std::size_t>(k)];
            const double pull = bound == Bound::Lower ? -slope[k] : bound == Bound::Upper ? slope[k] : 0;
            if (pull > strongest && lower[k] < upper[k]) {
                strongest = pull;
                release = k;
            }
        }
        if (release < 0) {
            break;
        }
        bounds[static_cast<std::size_t>(release)] = Bound::Free;
    }
    return step.cwiseMax(lower).cwiseMin(upper);
}

} // namespace core
