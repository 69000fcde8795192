// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/hand/demo_hand.h"

namespace core {

/// The demo hand's shape out of a parsed file of format handlens-demo-hand, which has passed its schema.
DemoHandShape demoHandShapeFromJson(const nlohmann::json& value);

/// A rig out of a parsed file of format handlens-rig, which has passed its schema. Throws Error(BadInput) naming `file` and
/// the field: a parent that does not come earlier, a joint named twice, an axis of no length, limits that
/// exclude the rest pose, joint axes that are parallel.
Rig rigFromJson(const nlohmann::json& value, const std::string& file);

} // namespace core
