// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/annotation/sequence_points.h"
#include "core/labelling/auto_labels.h"

namespace core {

/// A frame that a person has placed joints in; in the calibration's unit.
struct CorrectedFrame {
    int frame = 0;
    JointPoints joints;             ///< as the person has them, of one hand or both
    std::vector<AutoHand> labels{}; ///< as they were before: what is known of joints that the person has not placed
};

/// Brings the hands to a corrected frame's joints and then to its silhouettes, and tracks from there through `frames`
/// (ascending) to both sides, until a fit is in doubt, the frames end, a gap, fewer than three views or one of
/// `reviewed` comes. `hands`: those of the pass (PassResult::hands), or the models. The result holds the frames that it
/// reached, the corrected one among them; none if the joints are too few for a hand. Deterministic.
PassResult retrack(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                   const CorrectedFrame& corrected, const std::vector<int>& frames, const std::vector<int>& reviewed,
                   PassSource& source, const PassOptions& options, std::stop_token stop = {},
                   const PassProgress& progress = {}, const PassSink& sink = {});

} // namespace core
