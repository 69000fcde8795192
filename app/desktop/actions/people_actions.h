// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Whose marks they are: the person's name in the status line, the question for it at the first start (`mayAsk`), the
/// work of other people, and what an import would replace.
void bindPeopleActions(MainWindow& window, bool mayAsk);

} // namespace app
