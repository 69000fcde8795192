// SPDX-License-Identifier: MIT
#pragma once

#include "core/hand/hand_model.h"

namespace test {

/// A hand of three bones in a row (forearm, index_mcp, index_pip; 40 mm each along x) with a closed box of eight
/// vertices as its skin and three degrees of freedom: index_mcp flexion and abduction, index_pip flexion.
core::HandModel smallHand(core::Side side);

} // namespace test
