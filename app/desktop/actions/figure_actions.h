// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// The actions that save the compared pair: as a figure, as a film, as a page.
void bindFigureActions(MainWindow& window);

} // namespace app
