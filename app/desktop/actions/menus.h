// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Makes the menu bar from the action table.
void buildMenus(MainWindow& window);
/// Makes the slim bar of icons, with their texts on hover, and binds the action that hides it.
void buildToolbar(MainWindow& window);

} // namespace app
