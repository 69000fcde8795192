// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/benchmark/pairs.h"

namespace app {

/// What the command line says about a benchmark.
struct BenchmarkArguments {
    std::string dataset, pairs, shard, sweep, out;
    std::vector<std::string> setups = {"synthetic"};
    std::vector<std::string> sequences, settings;
    std::vector<std::string> methods = {"ch", "dch-thres", "dch-quant", "dch-quant2", "dch-dt3", "best"};
    std::vector<std::string> external;
    core::PairOptions draw;
    int threads = 1;
};

/// benchmark --sweep realism: every setting of simulated imperfection, one after another; what is finished is kept.
void runRealismSweep(const BenchmarkArguments& arguments);

} // namespace app
