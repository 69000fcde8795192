// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/benchmark/benchmark_results.h"
#include "core/benchmark/benchmark_run.h"
#include "core/benchmark/joint_errors.h"

namespace core {

/// What another tracker says of some pairs: its name in the tables and joints in the world, mm.
struct ExternalEstimates {
    std::string name;
    std::map<FramePair, JointPositions> joints;
};

/// The rows of another tracker among `pairs`, measured as runBenchmark measures; pairs that it does not have are left
/// out, and joints that it does not have do not enter its error. Iterations and seconds are 0. Throws Error(Usage) if
/// it has none of the pairs, a joint that the benchmark does not know, or the name of a method.
std::vector<PairResult> externalRows(const BenchmarkScene& scene, BenchmarkSetup setup,
                                     const std::vector<FramePair>& pairs, const ExternalEstimates& estimates);

} // namespace core
