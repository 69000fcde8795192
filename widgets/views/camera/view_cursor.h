// SPDX-License-Identifier: MIT
#pragma once

#include <QCursor>

namespace widgets {

/// A fine cross whose centre is open, so that the pixel under it stays visible.
QCursor placingCursor();

} // namespace widgets
