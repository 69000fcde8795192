// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace app {

/// An id of the action table as text.
inline QString id(const char* name) {
    return QString::fromLatin1(name);
}

} // namespace app
