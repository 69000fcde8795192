// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/demo_hand/choreography.h"
#include "core/demo_hand/demo_hand.h"

namespace core {

/// The demo hand's shape out of a parsed file of format handlens-demo-hand, which has passed its schema.
DemoHandShape demoHandShapeFromJson(const nlohmann::json& value);

/// The choreographies out of a parsed file of format handlens-demo-choreographies, which has passed its schema, for two
/// hands, left and right, with the demo's degrees of freedom. Throws Error(BadInput) naming `file` and the field: an
/// unknown shape, frames that do not ascend, a first key that leaves something open.
std::vector<Choreography> choreographiesFromJson(const nlohmann::json& value, const std::vector<HandModel>& hands,
                                                 const std::string& file);

} // namespace core
