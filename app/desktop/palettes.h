// SPDX-License-Identifier: MIT
#pragma once

#include <QPalette>
#include <QString>

class QApplication;

namespace app {

enum class Look {
    Dark,
    Light,
    System ///< as the desktop is
};

/// How looks are written in settings: "dark", "light", "system".
QString lookName(Look look);
/// Dark for a name that is none.
Look lookFromName(const QString& name);

/// Of Dark or Light.
QPalette paletteFor(Look look);
/// Fusion style, palette and the icons that are readable on it. The first call, before anything else changes the
/// palette, finds out how the desktop is.
void applyLook(QApplication& application, Look look);

} // namespace app
