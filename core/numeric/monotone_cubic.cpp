// SPDX-License-Identifier: MIT
#include "core/numeric/monotone_cubic.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace core {

namespace {

/// Slope at an inner sample: the weighted harmonic mean of both sides' secants, 0 at a local extremum.
double innerSlope(double widthBefore, double widthAfter, double secantBefore, double secantAfter) {
    if (secantBefore * secantAfter <= 0)
        return 0;
    const double weightBefore = 2 * widthAfter + widthBefore;
    const double weightAfter = widthAfter + 2 * widthBefore;
    return (weightBefore + weightAfter) / (weightBefore / secantBefore + weightAfter / secantAfter);
}

} // namespace

MonotoneCubic::MonotoneCubic(std::vector<double> x, std::vector<double> y)
    : m_x(std::move(x))
    , m_y(std::move(y))
    , m_slope(m_x.size(), 0.0) {
    assert(!m_x.empty() && m_x.size() == m_y.size());
    for (std::size_t i = 1; i + 1 < m_x.size(); ++i) {
        const double before = m_x[i] - m_x[i - 1];
        const double after = m_x[i + 1] - m_x[i];
        m_slope[i] = innerSlope(before, after, (m_y[i] - m_y[i - 1]) / before, (m_y[i + 1] - m_y[i]) / after);
    }
}

double MonotoneCubic::operator()(double x) const {
    if (x <= m_x.front())
        return m_y.front();
    if (x >= m_x.back())
        return m_y.back();
    const auto upper = std::upper_bound(m_x.begin(), m_x.end(), x);
    const auto i = static_cast<std::size_t>(upper - m_x.begin()) - 1;
    const double width = m_x[i + 1] - m_x[i];
    const double t = (x - m_x[i]) / width;
    const double s = 1 - t;
    return s * s * (1 + 2 * t) * m_y[i] + t * t * (3 - 2 * t) * m_y[i + 1] +
           width * t * s * (s * m_slope[i] - t * m_slope[i + 1]);
}

} // namespace core
