// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/io/dataset/dataset.h"

namespace core {

/// Writes a dataset that follows from another: `changed` is `original` with other hands or cameras. Footage and masks
/// stay where they are and are referred to, recorded poses are carried over as they are (the hands have the same
/// degrees of freedom), annotations are copied with their history. All at once, or nothing: `folder` may not exist or
/// must be empty. Throws Error.
void writeDerivedDataset(const Dataset& original, const Dataset& changed, const std::filesystem::path& folder);

} // namespace core
