// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/benchmark/benchmark_results.h"
#include "widgets/jobs/fit_runner.h"

namespace widgets {

/// What the status line says about the work of a workspace: what is shown, and its result or what to do next.
struct WorkWords {
    QString summary;
    QString advice;
};

/// Null outcome: nothing was fitted yet.
WorkWords fitWords(const FitOutcome* outcome);
/// Null results: none yet.
WorkWords benchmarkWords(const core::BenchmarkResults* results);

} // namespace widgets
