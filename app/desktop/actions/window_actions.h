// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Says what every action of the table does in this window.
void bindWindowActions(MainWindow& window);

} // namespace app
