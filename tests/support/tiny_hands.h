// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/hand/motion.h"

namespace test {

/// A closed box from `low` to `high`, outward.
core::TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// The smallest thing that is a hand: a palm of 60 mm (bone `forearm`) and one finger of 40 mm (bone `index_mcp`) that
/// bends about y by one angle. Left hands lie around x = -60, right ones around x = 60, fingers along z.
core::HandModel tinyHand(core::Side side);

std::vector<core::HandModel> tinyHands();

/// A motion of the tiny hands: both drift and bend a little from frame to frame.
core::Motion tinyMotion(int frames);

} // namespace test
