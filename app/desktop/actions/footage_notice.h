// SPDX-License-Identifier: MIT
#pragma once

namespace app {

class MainWindow;

/// Says, whenever a sequence opens, what its dataset says about its footage (lost frames, missing pictures, other
/// lengths and rates).
void bindFootageNotice(MainWindow& window);

} // namespace app
