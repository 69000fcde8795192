// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

namespace core {

/// Residuals of a camera explained by causes: r = design * unknowns, robust.
struct Regression {
    Eigen::VectorXd unknowns;
    Eigen::MatrixXd covariance;
    Eigen::VectorXd rest;    ///< residuals - design * unknowns
    Eigen::VectorXd weights; ///< per row; near 0 for a wrong click
    double scatterPx = 0;    ///< per axis, from the median
};

/// Solves for the unknowns by reweighted least squares (weights 1 / (1 + (r^2 / 9 s^2)^2), s the scatter). Two rows
/// (x, y) per click; `residuals` stacked alike. Empty if the unknowns are not fixed by the clicks.
std::optional<Regression> regress(const Eigen::MatrixXd& design, const Eigen::VectorXd& residuals);

} // namespace core
