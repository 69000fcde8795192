// SPDX-License-Identifier: MIT
#pragma once

#include "core/annotation/picture_gaps.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// Where a sequence has no picture: cameras without footage (no view, or one of kind None) have none at all, others
/// lack single instants.
PictureGaps pictureGaps(const Dataset& dataset, const Sequence& sequence);

} // namespace core
