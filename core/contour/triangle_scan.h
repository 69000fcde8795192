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
/// Within 2^17 px of the origin, so that differences fit as well.
struct FixedPoint {
    std::int32_t x;
    std::int32_t y;
};
inline constexpr std::int64_t kFixedPerPixel = 4096;

inline FixedPoint toFixed(const Eigen::Vector2d& px) {
    return {static_cast<std::int32_t>(std::lrint(px.x() * kFixedPerPixel)),
            static_cast<std::int32_t>(std::lrint(px.y() * kFixedPerPixel))};
}

/// Calls visit(x, y) for every pixel of the image whose centre lies in the triangle, whatever its orientation.
/// Centres on an edge belong to the triangle on one side of it only (the top-left rule), so that neighbours neither
/// overlap nor leave a gap.
template <typename Visit>
void scanTriangle(FixedPoint a, FixedPoint b, FixedPoint c, const ImageSize& size, Visit&& visit) {
    constexpr int kShift = 12;
    constexpr std::int32_t kLast = static_cast<std::int32_t>(kFixedPerPixel) - 1;
    const int x0 = std::max(0, (std::min({a.x, b.x, c.x}) + kLast) >> kShift);
    const int x1 = std::min(size.width - 1, std::max({a.x, b.x, c.x}) >> kShift);
    const int y0 = std::max(0, (std::min({a.y, b.y, c.y}) + kLast) >> kShift);
    const int y1 = std::min(size.height - 1, std::max({a.y, b.y, c.y}) >> kShift);
    if (x0 > x1 || y0 > y1)
        return;
    const auto product = [](std::int32_t p, std::int32_t q) { return static_cast<std::int64_t>(p) * q; };
    const std::int64_t area = product(b.x - a.x, c.y - a.y) - product(b.y - a.y, c.x - a.x);
    if (area == 0)
        return;
    if (area < 0)
        std::swap(b, c);
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
    for (int y = y0; y <= y1; ++y) {
        std::int64_t e0 = edges[0].value, e1 = edges[1].value, e2 = edges[2].value;
        bool entered = false;
        for (int x = x0; x <= x1; ++x) {
            if ((e0 | e1 | e2) >= 0) {
                entered = true;
                visit(x, y);
            } else if (entered) {
                break; // a row of a triangle is one run
            }
            e0 += edges[0].byX;
            e1 += edges[1].byX;
            e2 += edges[2].byX;
        }
        for (Edge& e : edges)
            e.value += e.byY;
    }
}

} // namespace core
