// SPDX-License-Identifier: MIT
#pragma once

namespace app {

/// Makes the icons and translations that are built in available; needed once, as they are part of a library.
void initResources();

} // namespace app
