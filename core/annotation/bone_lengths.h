// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include "core/annotation/sequence_points.h"

namespace core {

/// Length of each bone, by the joint at its far end, mm.
using BoneLengths = std::map<JointId, double>;

/// The length of the bone that ends in a joint, mm; no value without both of its ends.
std::optional<double> boneLength(const JointPoints& points, const JointId& joint);

/// The median over a sequence of each bone that is seen in at least `leastFrames` frames.
BoneLengths medianBoneLengths(const SequencePoints& points, int leastFrames);

} // namespace core
