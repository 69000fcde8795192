// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/benchmark_run.h"
#include "core/fitting/method.h"

namespace core {

enum class Verdict { Reproduced, NotReproduced, NotMeasured };
std::string_view verdictName(Verdict verdict); ///< "reproduced", "not reproduced", "not measured"

/// A claim of the paper and what our numbers say of it.
struct Finding {
    std::string claim;
    Verdict verdict = Verdict::NotMeasured;
    std::string numbers; ///< ours, in mm unless they say otherwise; what is missing if nothing was measured
};

/// Each claim of Tzionas and Gall (2013) under a schedule, from whatever methods the results hold. Mean errors over all
/// pairs are compared; differences below 0.02 mm (2 % of the seconds) count as equal, and a tie does not confirm a
/// claim: what is said to be better must beat the others. Where a claim says that something suffices, a tie does.
std::vector<Finding> findings(const BenchmarkResults& results, BenchmarkSetup setup, Schedule schedule);

} // namespace core
