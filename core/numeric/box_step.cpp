// SPDX-License-Identifier: MIT
#include "core/numeric/box_step.h"

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

namespace core {

namespace {

enum class Bound { Free, Lower, Upper };

/// The quadratic model, its box, and which unknowns are held at a bound.
class ActiveSet {
public:
    ActiveSet(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient, const Eigen::VectorXd& lower,
              const Eigen::VectorXd& upper)
        : m_hessian(hessian)
        , m_gradient(gradient)
        , m_lower(lower)
        , m_upper(upper)
        , m_size(gradient.size())
        , m_bounds(static_cast<std::size_t>(m_size), Bound::Free)
        , m_step(Eigen::VectorXd::Zero(m_size)) {}

    const Eigen::VectorXd& step() const { return m_step; }

    /// A first feasible step, nearly the best one: all unknowns that leave the box are held at once, until none does.
    void holdAllOutside() {
        for (bool changed = true; changed;) {
            m_step = minimumOfFree();
            changed = false;
            for (Eigen::Index k = 0; k < m_size; ++k) {
                if (isFree(k) && (m_step[k] < m_lower[k] || m_step[k] > m_upper[k])) {
                    hold(k, m_step[k] < m_lower[k] ? Bound::Lower : Bound::Upper);
                    changed = true;
                }
            }
        }
    }

    /// Frees the held unknown that the model pulls into the box most; false if there is none: the step is the best.
    bool releaseOne() {
        const Eigen::VectorXd slope = m_gradient + m_hessian * m_step;
        Eigen::Index strongest = -1;
        double most = 1e-12 * (1 + m_gradient.cwiseAbs().maxCoeff());
        for (Eigen::Index k = 0; k < m_size; ++k) {
            const double pull = isFree(k)                                               ? 0
                                : m_bounds[static_cast<std::size_t>(k)] == Bound::Lower ? -slope[k]
                                                                                        : slope[k];
            if (pull > most && m_lower[k] < m_upper[k]) {
                most = pull;
                strongest = k;
            }
        }
        if (strongest >= 0)
            m_bounds[static_cast<std::size_t>(strongest)] = Bound::Free;
        return strongest >= 0;
    }

    /// Goes to the best place of the free unknowns, or as far as the first of them that meets a bound, which then holds
    /// it. The cost never rises. True if it got there.
    bool advance() {
        const Eigen::VectorXd way = minimumOfFree() - m_step;
        double fraction = 1;
        Eigen::Index first = -1;
        for (Eigen::Index k = 0; k < m_size; ++k) {
            const double bound = way[k] < 0 ? m_lower[k] : m_upper[k];
            if (isFree(k) && std::abs(way[k]) * fraction > std::abs(bound - m_step[k])) {
                fraction = std::abs(bound - m_step[k]) / std::abs(way[k]);
                first = k;
            }
        }
        m_step += fraction * way;
        if (first >= 0)
            hold(first, way[first] < 0 ? Bound::Lower : Bound::Upper);
        return first < 0;
    }

private:
    bool isFree(Eigen::Index k) const { return m_bounds[static_cast<std::size_t>(k)] == Bound::Free; }

    void hold(Eigen::Index k, Bound bound) {
        m_bounds[static_cast<std::size_t>(k)] = bound;
        m_step[k] = bound == Bound::Lower ? m_lower[k] : m_upper[k];
    }

    /// The step whose free unknowns are the best for the held ones.
    Eigen::VectorXd minimumOfFree() const {
        std::vector<Eigen::Index> free;
        Eigen::VectorXd step = m_step;
        for (Eigen::Index k = 0; k < m_size; ++k) {
            if (isFree(k)) {
                free.push_back(k);
                step[k] = 0;
            }
        }
        if (!free.empty()) {
            const Eigen::VectorXd slope = m_gradient + m_hessian * step;
            const Eigen::MatrixXd reduced = m_hessian(free, free);
            const Eigen::VectorXd solved = reduced.llt().solve(-slope(free));
            step(free) = solved;
        }
        return step;
    }

    const Eigen::MatrixXd& m_hessian;
    const Eigen::VectorXd& m_gradient;
    const Eigen::VectorXd& m_lower;
    const Eigen::VectorXd& m_upper;
    Eigen::Index m_size;
    std::vector<Bound> m_bounds;
    Eigen::VectorXd m_step;
};

} // namespace

Eigen::VectorXd boxConstrainedStep(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
    ActiveSet set(hessian, gradient, lower, upper);
    set.holdAllOutside();
    // Every release lowers the cost, so no set of held unknowns comes back; the bound is for rounding only.
    const Eigen::Index mostRounds = 20 * gradient.size() + 100;
    bool atMinimum = true;
    for (Eigen::Index round = 0; round < mostRounds; ++round) {
        if (atMinimum && !set.releaseOne())
            break;
        atMinimum = set.advance();
    }
    return set.step().cwiseMax(lower).cwiseMin(upper);
}

} // namespace core
