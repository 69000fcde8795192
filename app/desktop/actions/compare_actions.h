// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// The actions about the columns of the Inspect workspace.
void bindCompareActions(MainWindow& window);

} // namespace app
