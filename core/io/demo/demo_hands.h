// SPDX-License-Identifier: MIT
#pragma once

#include "core/demo_hand/choreography.h"

namespace core {

/// The demo's hands, left and right, made from the shape and the rig that are built in.
std::vector<HandModel> makeDemoHands();

/// The demo's choreographies for any two hands, left and right, with its degrees of freedom.
std::vector<Choreography> demoChoreographies(const std::vector<HandModel>& hands);

} // namespace core
