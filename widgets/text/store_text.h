// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/io/store/annotation_store.h"

namespace widgets {

/// Why annotations cannot be changed, in the person's language.
QString readOnlyInWords(const core::ReadOnlyReason& reason);
/// What went wrong without harm when annotations were opened, in the person's language.
QString storeWarningInWords(const core::StoreWarning& warning);

} // namespace widgets
