// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/ring_views.h"

namespace core {

/// The demo: two hands of our own, four choreographies at 50 frames per second and 8 cameras of 1080x1920 on a ring, all
/// of it made from the data in resources/demo and resources/rigs that are built in. Takes about a second; deterministic.
NewDataset makeDemoDataset();

/// The demo's hands, left and right.
std::vector<HandModel> makeDemoHands();

} // namespace core
