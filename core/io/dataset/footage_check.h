// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/io/dataset/check_finding.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// Whether the footage of a sequence is there, of the calibrated size and long enough; and every note about it: those
/// that were said when the sequence was made, and those that the footage gives rise to now.
std::vector<CheckFinding> checkFootage(const Dataset& dataset, const Sequence& sequence);

} // namespace core
