// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Whose marks they are: the person's name in the status line, the question for it at the first start (`mayAsk`), the
/// work of other people, what an import would replace,
/// and what is known of the footage.
void bindPeopleActions(MainWindow& window, bool mayAsk);

} // namespace app
