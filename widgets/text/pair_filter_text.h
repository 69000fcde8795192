// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/benchmark/comparison/pair_filter.h"

namespace widgets {

/// Why a text is not a filter of pairs, and what it may be.
QString pairFilterProblemText(const core::PairFilterProblem& problem);

/// What may stand in a filter, with examples.
QString pairFilterHelp();

} // namespace widgets
