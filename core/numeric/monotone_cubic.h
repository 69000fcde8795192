// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace core {

/// Interpolates samples (x_i, y_i), x ascending, by a C1 piecewise cubic that never overshoots: between two samples it
/// stays between their values (Fritsch and Carlson 1980). Constant beyond both ends.
class MonotoneCubic {
public:
    /// At least one sample; x strictly ascending.
    MonotoneCubic(std::vector<double> x, std::vector<double> y);

    double operator()(double x) const;

private:
    std::vector<double> m_x;
    std::vector<double> m_y;
    std::vector<double> m_slope;
};

} // namespace core
