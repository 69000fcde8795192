// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/benchmark/benchmark_run.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// What the benchmark measures, read from a dataset: the named sequences, or all that have a recorded motion if none is
/// named. Realistic: annotations and the pattern of the masks are read too, mask files when they are needed.
/// Throws Error naming the sequence and what it lacks: recorded motion, or (realistic) masks or annotated 3D joints.
BenchmarkScene readBenchmarkScene(const Dataset& dataset, const std::vector<std::string>& sequences,
                                  BenchmarkSetup setup);

} // namespace core
