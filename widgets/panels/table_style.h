// SPDX-License-Identifier: MIT
#pragma once

class QTableView;

namespace widgets {

/// The look that all tables share: rows, dense, no grid, no row numbers, the first column takes the space that is left.
void styleTable(QTableView& table);

} // namespace widgets
