// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include "core/geometry/camera.h"

namespace core {

/// A pixel position in 1/4096 px: exact integer edge functions make the pixel-centre rule exact.
struct FixedPoint {
    std::int64_t x;
    std::int64_t y;
};
inline constexpr std::int64_t kFixedPerPixel = 4096;

inline FixedPoint toFixed(const Eigen::Vector2d& px) {
    return {std::llround(px.x() * kFixedPerPixel), std::llround(px.y() * kFixedPerPixel)};
}

/// Calls visit(x, y) for every pixel of the image whose centre lies in the triangle, whatever its orientation.
/// Centres on an edge belong to the triangle on one side of it only (the top-left rule), so that neighbours neither
/// overlap nor leave a gap.
template <typename Visit>
void scanTriangle(FixedPoint a, FixedPoint b, FixedPoint c, const ImageSize& size, Visit&& visit) {
    const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) {
        return;
    }
    if (area < 0) {
        std::swap(b, c);
    }
    constexpr int kShift = 12;
    const auto ceilPx = [](std::int64_t v) { return (v + kFixedPerPixel - 1) >> kShift; };
    const std::int64_t x0 = std::max<std::int64_t>(0, ceilPx(std::min({a.x, b.x, c.x})));
    const std::int64_t y0 = std::max<std::int64_t>(0, ceilPx(std::min({a.y, b.y, c.y})));
    const std::int64_t x1 = std::min<std::int64_t>(size.width - 1, std::max({a.x, b.x, c.x}) >> kShift);
    const std::int64_t y1 = std::min<std::int64_t>(size.height - 1, std::max({a.y, b.y, c.y}) >> kShift);
    if (x0 > x1 || y0 > y1) {
        return;
    }
    struct Edge {
        std::int64_t value, byX, byY;
    };
    // Inside is value >= 0 of every edge; edges that do not own their centres are shifted by one unit.
    const auto edge = [&](const FixedPoint& from, const FixedPoint& to) {
        const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
        const bool owns = dy < 0 || (dy == 0 && dx > 0);
        const std::int64_t value =
            dx * (y0 * kFixedPerPixel - from.y) - dy * (x0 * kFixedPerPixel - from.x) - (owns ? 0 : 1);
        return Edge{value, -dy * kFixedPerPixel, dx * kFixedPerPixel};
    };
    std::array<Edge, 3> edges{edge(a, b), edge(b, c), edge(c, a)};
    for (std::int64_t y = y0; y <= y1; ++y) {
        std::int64_t e0 = edges[0].value, e1 = edges[1].value, e2 = edges[2].value;
        for (std::int64_t x = x0; x <= x1; ++x) {
            if ((e0 | e1 | e2) >= 0) {
                visit(static_cast<int>(x), static_cast<int>(y));
            }
            e0 += edges[0].byX;
            e1 += edges[1].byX;
            e2 += edges[2].byX;
        }
        for (Edge& e : edges) {
            e.value += e.byY;
        }
    }
}

} // namespace core
