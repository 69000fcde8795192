// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/benchmark/benchmark_run.h"
#include "core/benchmark/realism_settings.h"

namespace core {

/// A scene for the realistic setup, simulated in memory from recorded motion: silhouettes of the setting's world, seen
/// by its cameras, while hands and cameras of the scene stay those of `clean` (or, adapted, are refined and measured
/// from the clicks of five frames of the whole scene). Errors are taken over the joints that people can click, in the
/// test frames of `pairs`: against their triangulated clicks, or against the true joints, which are first moved rigidly
/// to where the scene's cameras place them. The same for a seed.
BenchmarkScene realismScene(const BenchmarkScene& clean, const RealismSetting& setting,
                            const std::vector<FramePair>& pairs, std::uint64_t seed, std::stop_token stop = {});

} // namespace core
