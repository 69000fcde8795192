// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "app/desktop/main_window.h"

namespace app {

/// A window with all that it can do: its actions bound, its menus and its toolbar made, the person's preferences
/// applied.
std::unique_ptr<MainWindow> makeMainWindow(QSettings& settings, const WindowOptions& options);

} // namespace app
