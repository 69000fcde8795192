// SPDX-License-Identifier: MIT
#pragma once

#include "core/demo_hand/choreography.h"

namespace core {

/// The demo's hands, left and right, made from the shape and the rig that are built in. The first call makes them,
/// about a second long.
const std::vector<HandModel>& demoHands();

/// The demo's choreographies for any two hands, left and right, with its degrees of freedom.
std::vector<Choreography> demoChoreographies(const std::vector<HandModel>& hands);

} // namespace core
