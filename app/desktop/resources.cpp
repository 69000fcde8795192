// SPDX-License-Identifier: MIT
#include "app/desktop/resources.h"

#include <QtGlobal>

// Q_INIT_RESOURCE must stand outside of every namespace.
static void initEmbeddedResources() {
    Q_INIT_RESOURCE(icons);
    Q_INIT_RESOURCE(translations);
}

namespace app {

void initResources() {
    initEmbeddedResources();
}

} // namespace app
