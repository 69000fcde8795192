// SPDX-License-Identifier: MIT
#include "core/annotation/interpolation.h"

#include <iterator>

namespace core {

namespace {

using Curve = std::map<int, Eigen::Vector3d>;

/// Derivative (per frame) at `at` of the parabola through three points.
Eigen::Vector3d parabolaSlope(const Curve::value_type& a, const Curve::value_type& b, const Curve::value_type& c,
                              int at) {
    const double x0 = a.first, x1 = b.first, x2 = c.first, x = at;
    return a.second * ((2 * x - x1 - x2) / ((x0 - x1) * (x0 - x2))) +
           b.second * ((2 * x - x0 - x2) / ((x1 - x0) * (x1 - x2))) +
           c.second * ((2 * x - x0 - x1) / ((x2 - x0) * (x2 - x1)));
}

/// Slope at a knot: of the parabola through it and its neighbours, or at an end through the three last ones.
Eigen::Vector3d slopeAt(const Curve& points, Curve::const_iterator knot) {
    auto middle = knot;
    if (middle == points.begin())
        ++middle;
    else if (std::next(middle) == points.end())
        --middle;
    return parabolaSlope(*std::prev(middle), *middle, *std::next(middle), knot->first);
}

} // namespace

std::optional<Eigen::Vector3d> interpolated(const Curve& points, int frame, Interpolation kind) {
    const auto after = points.lower_bound(frame);
    if (after == points.end())
        return std::nullopt;
    if (after->first == frame)
        return after->second;
    if (after == points.begin())
        return std::nullopt;
    const auto before = std::prev(after);
    const double span = after->first - before->first;
    const double t = (frame - before->first) / span;
    if (kind == Interpolation::Linear || points.size() < 3)
        return (1 - t) * before->second + t * after->second;
    const Eigen::Vector3d slopeBefore = span * slopeAt(points, before), slopeAfter = span * slopeAt(points, after);
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * before->second + (t3 - 2 * t2 + t) * slopeBefore +
           (3 * t2 - 2 * t3) * after->second + (t3 - t2) * slopeAfter;
}

} // namespace core
