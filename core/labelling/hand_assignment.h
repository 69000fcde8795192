// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/detection/hand_views.h"
#include "core/hand/hand_model.h"

namespace core {

/// What the detector saw of each hand model, parallel to the models; none where a hand was not seen.
using HandDetections = std::vector<std::optional<SpatialHand>>;

/// Says which detected hand of every frame is which model's: by what all views of all frames say of its side
/// (giveSides), except where the models' shapes clearly say that the hands of a frame are the other way round.
/// `models` as withTips gives them, `frames` in mm.
std::map<int, HandDetections> assignHands(const std::vector<HandModel>& models,
                                          const std::map<int, std::vector<SpatialHand>>& frames);

} // namespace core
