// SPDX-License-Identifier: MIT
#pragma once

#include "core/demo_hand/choreography.h"
#include "core/io/dataset/ring_views.h"

namespace core {

/// The demo: two hands of our own, four choreographies at 50 frames per second and 8 cameras of 1080x1920 on a ring,
/// all of it made from the data in resources/demo and resources/rigs that are built in. Takes about a second;
/// deterministic.
NewDataset makeDemoDataset();

/// The demo's hands, left and right.
std::vector<HandModel> makeDemoHands();

/// The demo's choreographies for any two hands, left and right, with its degrees of freedom.
std::vector<Choreography> demoChoreographies(const std::vector<HandModel>& hands);

/// A dataset of choreographies played by hands: one sequence each, 50 frames per second, 8 cameras on a ring, rendered
/// views.
NewDataset playedDataset(const std::vector<HandModel>& hands, const std::vector<Choreography>& choreographies);

} // namespace core
