// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>
#include <QSizeF>

namespace widgets {

/// Rows and columns of a grid of equal cells.
struct GridShape {
    int rows = 1;
    int columns = 1;
    bool operator==(const GridShape&) const = default;
};

/// The grid in which `count` pictures of `aspect` (width / height) cover the most of `area`; each cell loses
/// `titleHeight` px at its top. Ties go to fewer empty cells, then to fewer rows. count >= 1.
GridShape packGrid(int count, double aspect, QSize area, int titleHeight);

} // namespace widgets
