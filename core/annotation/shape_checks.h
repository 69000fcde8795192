// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/annotation/bone_lengths.h"
#include "core/annotation/quality.h"
#include "core/annotation/sequence_points.h"

namespace core {

/// Findings about the 3D joints of one frame from nothing but these: bone lengths, finger order, handedness. `previous`
/// are the points of the annotated frame before, if it is near: it tells whether hands were exchanged.
void checkShape(int frame, const JointPoints& points, const BoneLengths& lengths, const JointPoints* previous,
                const QualityOptions& options, std::vector<QualityFinding>& findings);

} // namespace core
