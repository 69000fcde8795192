// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Silhouettes from the pictures: their window, the brush, and the run over a range of frames.
void bindSilhouetteActions(MainWindow& window);

} // namespace app
