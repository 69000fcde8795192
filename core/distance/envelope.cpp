// SPDX-License-Identifier: MIT
#include "core/distance/envelope.h"

#include <cmath>
#include <limits>

namespace core {

namespace {

/// A column without a site; larger than any distance within an image, and its sum with 1 does not overflow.
constexpr int kNoSite = std::numeric_limits<int>::max() / 2;

void markSites(const std::vector<GridSite>& sites, ColumnDistances& columns) {
    for (const GridSite& site : sites) {
        const auto at = static_cast<std::size_t>(site.y) * static_cast<std::size_t>(columns.cols) +
                        static_cast<std::size_t>(site.x);
        if (columns.index[at] < 0 || site.index < columns.index[at]) {
            columns.index[at] = site.index;
            columns.distance[at] = 0;
        }
    }
}

/// Offers every pixel of `row` what its neighbour in `from` has, one pixel farther.
void relaxRow(ColumnDistances& columns, int from, int row) {
    const auto offset = [&](int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns.cols); };
    const int* fromDistance = columns.distance.data() + offset(from);
    const int* fromIndex = columns.index.data() + offset(from);
    int* distance = columns.distance.data() + offset(row);
    int* index = columns.index.data() + offset(row);
    for (int x = 0; x < columns.cols; ++x) {
        const int offered = fromDistance[x] + 1;
        const bool nearer = offered < distance[x];
        const bool tie = offered == distance[x];
        const bool take = nearer | (tie & (fromIndex[x] < index[x]));
        distance[x] = take ? offered : distance[x];
        index[x] = take ? fromIndex[x] : index[x];
    }
}

int floorDivided(int numerator, int positiveDenominator) {
    const int quotient = numerator / positiveDenominator;
    return quotient - (numerator % positiveDenominator < 0 ? 1 : 0);
}

} // namespace

ColumnDistances nearestInColumns(const std::vector<GridSite>& sites, cv::Size size) {
    const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    ColumnDistances columns{size.height, size.width, std::vector<int>(pixels, kNoSite), std::vector<int>(pixels, -1)};
    markSites(sites, columns);
    for (int row = 1; row < columns.rows; ++row)
        relaxRow(columns, row - 1, row);
    for (int row = columns.rows - 2; row >= 0; --row)
        relaxRow(columns, row + 1, row);
    return columns;
}

/// True if the challenger is nearer at pixel x, or as near with a smaller index.
bool RowEnvelope::beats(const Segment& challenger, const Segment& holder, int x) {
    const int c = (x - challenger.column) * (x - challenger.column) + challenger.squared;
    const int h = (x - holder.column) * (x - holder.column) + holder.squared;
    return c < h || (c == h && challenger.index < holder.index);
}

/// The first pixel at which the challenger, whose column is to the right, beats the holder.
int RowEnvelope::firstWin(const Segment& challenger, const Segment& holder) {
    const int c = challenger.column;
    const int h = holder.column;
    const int numerator = c * c + challenger.squared - h * h - holder.squared;
    const int denominator = 2 * (c - h);
    const int last = floorDivided(numerator, denominator);
    const bool tieWins = last * denominator == numerator && challenger.index < holder.index;
    return tieWins ? last : last + 1;
}

int RowEnvelope::build(const int* distances, const int* indices, int cols) {
    int count = 0;
    for (int x = 0; x < cols; ++x) {
        if (indices[x] < 0)
            continue;
        Segment challenger{x, 0, distances[x] * distances[x], indices[x]};
        while (count > 0) {
            const Segment& holder = m_segments[static_cast<std::size_t>(count - 1)];
            if (!beats(challenger, holder, holder.first))
                break;
            --count;
        }
        if (count > 0)
            challenger.first = firstWin(challenger, m_segments[static_cast<std::size_t>(count - 1)]);
        if (challenger.first < cols)
            m_segments[static_cast<std::size_t>(count++)] = challenger;
    }
    return count;
}

void RowEnvelope::run(const ColumnDistances& columns, int row, float* distancePx, int* index) {
    const auto offset = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns.cols);
    const int count = build(columns.distance.data() + offset, columns.index.data() + offset, columns.cols);
    if (count == 0) {
        std::fill_n(distancePx, columns.cols, std::numeric_limits<float>::infinity());
        std::fill_n(index, columns.cols, -1);
        return;
    }
    for (int s = 0; s < count; ++s) {
        const Segment& segment = m_segments[static_cast<std::size_t>(s)];
        const int end = s + 1 < count ? m_segments[static_cast<std::size_t>(s + 1)].first : columns.cols;
        for (int x = segment.first; x < end; ++x) {
            const int dx = x - segment.column;
            distancePx[x] = std::sqrt(static_cast<float>(dx * dx + segment.squared));
            index[x] = segment.index;
        }
    }
}

} // namespace core
