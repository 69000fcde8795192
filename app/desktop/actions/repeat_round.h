// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// What begins and ends a repeat round: a question before the first marks are hidden, and a banner as long as they are.
void bindRepeatRound(MainWindow& window);

} // namespace app
