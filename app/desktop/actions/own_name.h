// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace app {

class MainWindow;

/// The name that marks are kept under, without the suffix of a repeat round.
QString ownName(MainWindow& window);
/// Keeps that name from now on; an empty one changes nothing.
void keepOwnName(MainWindow& window, const QString& name);

} // namespace app
