// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// The calibration's health and refinement, and measuring a person's hands: actions, their windows, and what the status
/// line says of them.
void bindRigActions(MainWindow& window);

} // namespace app
