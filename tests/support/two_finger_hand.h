// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/hand/hand_model.h"
#include "tests/support/random_values.h"

namespace test {

/// A rigid mesh as a hand: one bone, no degrees of freedom but the rigid ones.
core::HandModel rigidHand(core::TriangleMesh mesh);

/// A small skinned hand: a flat palm and two fingers of two bones each, 12 degrees of freedom, about 2900 vertices.
/// In its own frame the palm lies in the xy plane and the index finger points along x.
core::HandModel twoFingerHand(core::Side side, const core::RigidMotion& worldFromHand = {});

/// Left and right, palms towards each other and fingers crossing.
std::vector<core::HandModel> twoFingerHands();

/// A pose well inside the limits of the two-finger hand.
core::Pose somePose(const core::Skeleton& skeleton, RandomValues& random, double rigidMm = 15, double rigidRad = 0.4);

} // namespace test
