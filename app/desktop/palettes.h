// SPDX-License-Identifier: MIT
#pragma once

#include <QPalette>

class QApplication;

namespace app {

enum class Look { Dark, Light };

QPalette paletteFor(Look look);
/// Fusion style, palette and the icons that are readable on it.
void applyLook(QApplication& application, Look look);

} // namespace app
