// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core/types.hpp>

#include "core/distance/grid_sites.h"

namespace core {

/// First pass of an exact distance transform: for every pixel, the nearest site of the pixel's own column (rows x cols,
/// row-major). Ties go to the smaller index; index is -1 where the column is empty.
struct ColumnDistances {
    int rows = 0;
    int cols = 0;
    std::vector<int> distance;
    std::vector<int> index;
};
ColumnDistances nearestInColumns(const std::vector<GridSite>& sites, cv::Size size);

/// Second pass: the lower envelope of the parabolas over one row.
class RowEnvelope {
public:
    explicit RowEnvelope(int cols)
        : m_segments(static_cast<std::size_t>(cols)) {}

    /// Writes the distance in pixels (infinity if there is no site) and the index (-1) for each of the row's pixels.
    void run(const ColumnDistances& columns, int row, float* distancePx, int* index);

private:
    struct Segment {
        int column;  ///< whose parabola is lowest ...
        int first;   ///< ... from this pixel on
        int squared; ///< height of the parabola: squared distance within the column
        int index;
    };

    static bool beats(const Segment& challenger, const Segment& holder, int x);
    static int firstWin(const Segment& challenger, const Segment& holder);
    int build(const int* distances, const int* indices, int cols);

    std::vector<Segment> m_segments;
};

} // namespace core
