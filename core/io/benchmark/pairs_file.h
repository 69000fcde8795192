// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/benchmark/pairs.h"

namespace core {

/// {"pairs":[{"sequence","start","test","difference"}]}; `difference` may be missing when read, and must be right if it
/// is there. Throws Error naming file and field, also for a pair that is listed twice.
std::vector<FramePair> readPairs(const std::filesystem::path& file);
void writePairs(const std::filesystem::path& file, const std::vector<FramePair>& pairs);

} // namespace core
