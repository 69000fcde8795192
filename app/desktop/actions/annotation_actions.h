// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Binds the actions that edit many marks at once, and the list of joints.
void bindAnnotationActions(MainWindow& window);

} // namespace app
