// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/benchmark/external_rows.h"

namespace core {

/// Reads the estimates of another tracker.
/// CSV (any name but *.json): the header sequence,start,test,hand,name,x,y,z, then a line per joint, mm.
/// JSON: {"estimates":[{"sequence","start","test","joints":[{"hand","name","xyz"}]}]}, or "poses" instead of "joints":
/// one list of pose parameters per hand of the dataset. Throws Error naming file and line or field; a joint that is
/// listed twice is refused.
ExternalEstimates readExternalEstimates(const std::string& name, const std::filesystem::path& file,
                                        const std::vector<HandModel>& hands);

} // namespace core
