// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/io/store/annotation_store.h"

namespace widgets {

/// Why annotations cannot be changed, in the person's language.
QString readOnlyInWords(const core::ReadOnlyReason& reason);

} // namespace widgets
