// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// The first pass and the review of what it proposed: actions, what the status line says of them, and the timeline.
void bindReviewActions(MainWindow& window);

} // namespace app
