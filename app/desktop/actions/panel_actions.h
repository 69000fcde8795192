// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Binds the actions that open panels, small windows and file dialogs, and the context menu of the views.
void bindPanelActions(MainWindow& window);

} // namespace app
