// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/hand/hand_model.h"

namespace core {

/// Poses of all hands over time, one entry per frame.
using Motion = std::vector<HandPoses>;

/// Mean joint displacement between frames `apart` frames apart, over all pairs of one motion, mm; 0 if there is no such
/// pair.
double meanDisplacementMm(const std::vector<HandModel>& hands, const Motion& motion, int apart);

} // namespace core
