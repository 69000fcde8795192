// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Makes the menu bar from the action table.
void buildMenus(MainWindow& window);

} // namespace app
