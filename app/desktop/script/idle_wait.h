// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace app {

class MainWindow;

/// Runs the event loop until everything in the window is done and drawn: jobs, pictures, posted events, mesh layers.
/// Returns false after `timeoutMs`.
bool waitUntilIdle(MainWindow& window, int timeoutMs = 120000);
/// Runs the event loop until `condition` holds, looked at whenever a job has ended. Returns false after `timeoutMs`.
bool waitFor(MainWindow& window, const std::function<bool()>& condition, int timeoutMs = 120000);
/// Runs the event loop for a time.
void waitMs(int milliseconds);
/// Lets every view draw what was changed, on this thread and now.
void drawNow(MainWindow& window);

} // namespace app
