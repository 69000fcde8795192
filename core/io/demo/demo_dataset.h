// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/dataset/ring_views.h"
#include "core/io/demo/demo_hands.h"

namespace core {

/// The demo: two hands of our own, four choreographies at 50 frames per second and 8 cameras of 1080x1920 on a ring,
/// all of it made from the data in resources/demo and resources/rigs that are built in. Takes about a second;
/// deterministic.
NewDataset makeDemoDataset();

/// A dataset of choreographies played by hands: one sequence each, 50 frames per second, 8 cameras on a ring, rendered
/// views.
NewDataset playedDataset(const std::vector<HandModel>& hands, const std::vector<Choreography>& choreographies);

} // namespace core
