// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "core/detection/hand_sides.h"

namespace core {

/// How much each hand of each frame deserves a look, 0 (sure) .. 1 (lost): few views that agree, landmarks that do not
/// meet, bones of another length than in the other frames, a side that is not clear. `pictures`: how many cameras have
/// a picture. The result is parallel to `frames`.
std::map<int, std::vector<double>> doubtsOf(const std::map<int, std::vector<SidedHand>>& frames, int pictures);

} // namespace core
