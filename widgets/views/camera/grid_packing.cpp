// SPDX-License-Identifier: MIT
#include "widgets/views/camera/grid_packing.h"

#include <algorithm>

namespace widgets {

namespace {

/// How much of the area the pictures cover, px^2.
double coveredArea(const GridShape& shape, int count, double aspect, QSize area, int titleHeight) {
    const double width = static_cast<double>(area.width()) / shape.columns;
    const double height = static_cast<double>(area.height()) / shape.rows - titleHeight;
    if (width <= 0 || height <= 0)
        return 0;
    const double pictureWidth = std::min(width, height * aspect);
    return count * pictureWidth * pictureWidth / aspect;
}

} // namespace

GridShape packGrid(int count, double aspect, QSize area, int titleHeight) {
    GridShape best{1, std::max(1, count)};
    double bestArea = -1;
    int bestEmpty = 0;
    for (int rows = 1; rows <= count; ++rows) {
        const GridShape shape{rows, (count + rows - 1) / rows};
        const int empty = shape.rows * shape.columns - count;
        if (empty >= shape.columns)
            continue; // a whole row would stay empty
        const double covered = coveredArea(shape, count, aspect, area, titleHeight);
        const bool larger = covered > bestArea * (1 + 1e-9);
        const bool tie = !larger && covered > bestArea * (1 - 1e-9);
        if (larger || (tie && empty < bestEmpty)) {
            best = shape;
            bestArea = covered;
            bestEmpty = empty;
        }
    }
    return best;
}

} // namespace widgets
