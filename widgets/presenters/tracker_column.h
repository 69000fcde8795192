// SPDX-License-Identifier: MIT
#pragma once

#include "core/benchmark/external_rows.h"
#include "core/io/dataset/dataset.h"
#include "widgets/jobs/fit_runner.h"

namespace widgets {

/// What another tracker says of a fitted pair, as a column: the hand models fitted to its joints for the pictures, the
/// error over its joints themselves. A failure where it has no estimate of the pair. Slow: not for the window's thread.
MethodOutcome trackerColumn(const core::Dataset& dataset, const FitOutcome& outcome,
                            const core::ExternalEstimates& estimates, const std::string& columnId);

} // namespace widgets
