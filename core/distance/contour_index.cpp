// SPDX-License-Identifier: MIT
#include "core/distance/contour_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/distance/circular_distance.h"

namespace core {

ContourIndex::ContourIndex(const OrientedContour& contour, const OrientationBins& bins)
    : m_bins(bins) {
    m_binDistance.resize(static_cast<std::size_t>(bins.count()) * bins.count());
    for (int a = 0; a < bins.count(); ++a)
        for (int b = 0; b < bins.count(); ++b)
            m_binDistance[a * bins.count() + b] = static_cast<float>(bins.distanceRad(a, b));
    if (contour.empty())
        return;
    const auto [left, right] = std::minmax_element(contour.x.begin(), contour.x.end());
    const auto [top, bottom] = std::minmax_element(contour.y.begin(), contour.y.end());
    m_originX = *left;
    m_originY = *top;
    m_columns = static_cast<int>((*right - *left) / kCellPx) + 1;
    m_rows = static_cast<int>((*bottom - *top) / kCellPx) + 1;
    const auto cellOf = [&](std::size_t i) {
        const int column = static_cast<int>((contour.x[i] - m_originX) / kCellPx);
        const int row = static_cast<int>((contour.y[i] - m_originY) / kCellPx);
        return row * m_columns + column;
    };
    m_firstInCell.assign(static_cast<std::size_t>(m_columns) * m_rows + 1, 0);
    for (std::size_t i = 0; i < contour.size(); ++i)
        ++m_firstInCell[cellOf(i) + 1];
    for (std::size_t c = 1; c < m_firstInCell.size(); ++c)
        m_firstInCell[c] += m_firstInCell[c - 1];
    m_index.resize(contour.size());
    std::vector<int> next(m_firstInCell.begin(), m_firstInCell.end() - 1);
    for (std::size_t i = 0; i < contour.size(); ++i)
        m_index[next[cellOf(i)]++] = static_cast<int>(i);
    for (int i : m_index) {
        m_x.push_back(contour.x[i]);
        m_y.push_back(contour.y[i]);
        m_angle.push_back(contour.angleRad[i]);
        m_bin.push_back(bins.binOf(contour.angleRad[i]));
    }
}

template <typename Cost>
ContourMatch ContourIndex::search(float x, float y, float gatePx, Cost&& costOf) const {
    ContourMatch best;
    best.distance = std::numeric_limits<float>::infinity();
    if (m_index.empty())
        return best;
    const int column = static_cast<int>(std::floor((x - m_originX) / kCellPx));
    const int row = static_cast<int>(std::floor((y - m_originY) / kCellPx));
    const auto visitCells = [&](int r, int c0, int c1) {
        if (r < 0 || r >= m_rows)
            return;
        c0 = std::max(c0, 0);
        c1 = std::min(c1, m_columns - 1);
        if (c0 > c1)
            return;
        const int end = m_firstInCell[r * m_columns + c1 + 1];
        for (int i = m_firstInCell[r * m_columns + c0]; i < end; ++i) {
            const float dx = x - m_x[i], dy = y - m_y[i];
            const float distance = std::sqrt(dx * dx + dy * dy);
            if (distance > gatePx || distance > best.distance)
                continue;
            const float cost = distance + costOf(i);
            if (cost < best.distance || (cost == best.distance && m_index[i] < best.index))
                best = {m_index[i], cost};
        }
    };
    // Rings that do not reach the grid are skipped; nothing in ring k is nearer than (k - 1) cells and the way to the
    // border.
    const int outside = std::max({0, -column, -row, column - m_columns + 1, row - m_rows + 1});
    const int last = outside + std::max(m_columns, m_rows);
    for (int ring = outside; ring <= last; ++ring) {
        const float nearestPossible = static_cast<float>(std::max(0, ring - 1)) * kCellPx;
        if (nearestPossible > best.distance || nearestPossible > gatePx)
            break;
        visitCells(row - ring, column - ring, column + ring);
        if (ring == 0)
            continue;
        for (int r = row - ring + 1; r < row + ring; ++r) {
            visitCells(r, column - ring, column - ring);
            visitCells(r, column + ring, column + ring);
        }
        visitCells(row + ring, column - ring, column + ring);
    }
    return best;
}

ContourMatch ContourIndex::nearest(float x, float y, float gatePx) const {
    return search(
        x, y, gatePx, [](int) { return 0.0f; });
}

ContourMatch ContourIndex::nearestInBin(float x, float y, int bin, float gatePx) const {
    return search(
        x, y, gatePx, [&](int i) { return m_bin[i] == bin ? 0.0f : std::numeric_limits<float>::infinity(); });
}

ContourMatch ContourIndex::nearestWithin(float x, float y, float angleRad, float tauRad, float gatePx) const {
    return search(
        x, y, gatePx,
        [&](int i) {
            return circularDistance(static_cast<double>(m_angle[i]), static_cast<double>(angleRad), m_bins.isSigned()) <
                           static_cast<double>(tauRad)
                       ? 0.0f
                       : std::numeric_limits<float>::infinity();
        });
}

ContourMatch ContourIndex::nearestDirectional(float x, float y, int bin, float lambdaPxPerRad, float gatePx) const {
    const float* fromBin = m_binDistance.data() + static_cast<std::size_t>(bin) * m_bins.count();
    return search(x, y, gatePx, [&](int i) { return lambdaPxPerRad * fromBin[m_bin[i]]; });
}

} // namespace core
