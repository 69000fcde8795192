// SPDX-License-Identifier: MIT
#pragma once

#include "core/demo_hand/demo_hand_shape.h"
#include "core/hand/hand_model.h"
#include "core/hand/rig.h"

namespace core {

/// The demo hand: its closed surface, its skeleton by `rig` (whose joints must be wrist and those of the rays, named
/// FINGER_cmc, FINGER_mcp, ...) and smooth weights. Deterministic.
HandModel makeDemoHand(const DemoHandShape& shape, const Rig& rig);

/// The same hand of the other side, mirrored at the plane y = 0. The same pose angles mean the same movement.
HandModel mirroredHand(const HandModel& hand);

} // namespace core
