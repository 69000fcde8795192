// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Export, import, report and pictures: what reads and writes files of the person's choice.
void bindFileActions(MainWindow& window);

} // namespace app
