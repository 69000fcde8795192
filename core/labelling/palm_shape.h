// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/labelling/landmark_fit.h"

namespace core {

/// The model with the palm of the hand that targets were seen of: where the first targeted joint of every finger lies
/// in the rest pose, which a length along the model's own bones cannot say. What hangs on such a joint moves along;
/// lengths of fingers, weights and degrees of freedom stay. `frames`: the targets of one frame each (mm). Poses and
/// palm in turn; with fewer than three frames the model as it is. Deterministic.
HandModel withPalmOf(const HandModel& hand, const std::vector<std::vector<JointTarget>>& frames,
                     const LandmarkFitOptions& options);

} // namespace core
