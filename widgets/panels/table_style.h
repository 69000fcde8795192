// SPDX-License-Identifier: MIT
#pragma once

class QTableView;

namespace widgets {

/// The look that all tables share: rows, dense, no grid, no row numbers, the first column takes the space that is left.
void styleTable(QTableView& table);

/// How high a styled table must be to show that many rows below its header, with room for a horizontal scroll bar.
int heightOfRows(const QTableView& table, int rows);

} // namespace widgets
