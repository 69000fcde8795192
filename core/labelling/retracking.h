// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/annotation/sequence_points.h"
#include "core/labelling/auto_labels.h"

namespace core {

/// A frame that a person has placed joints in; in the calibration's unit.
struct CorrectedFrame {
    int frame = 0;
    JointPoints joints; ///< as the person has placed them, of one hand or both
    /// Where programs have the joints that the person has not placed, accepted or not: about there, unless a joint that
    /// the person placed says that its finger is elsewhere.
    std::map<JointId, Eigen::Vector3d> guesses{};
    std::map<int, double> doubts{}; ///< of the labels that there are, by frame; 1 where none is given
    /// Where the joints of another frame are now, whoever has placed them; asked for where the label that is there and
    /// the one that would replace it are both in doubt. Not set: there are no other labels.
    std::function<std::map<JointId, Eigen::Vector3d>(int frame)> labelsAt{};
};

/// A frame as the marks of a rater have it: joints that are clicked, and proposals, accepted or not, of the others. The
/// doubts are those of the proposals of all frames, the labels those of the set, which must outlive the result.
/// `fitted`: the cameras that hands are followed with (PassResult::cameras), in which the clicks are placed; empty: the
/// same. Proposals were drawn with `cameras`.
CorrectedFrame correctedFrame(const AnnotationSet& set, const std::vector<Camera>& cameras, int frame,
                              const std::string& rater, const std::vector<Camera>& fitted = {});

/// Brings the hands to a corrected frame's joints and then to its silhouettes, which are held to the joints that the
/// person has placed, and tracks from there through `frames` (ascending) to both sides, until a fit is in doubt and
/// more than the label that was there, or both are in doubt and the label explains the silhouettes better, the frames
/// end, a gap, fewer than three views or one of `reviewed` comes. `hands`: those of the pass (PassResult::hands), or
/// the models. The result holds the frames that it reached, the corrected one among them; none if the joints are too
/// few for a hand. Deterministic.
PassResult retrack(const std::vector<HandModel>& hands, const std::vector<Camera>& cameras,
                   const CorrectedFrame& corrected, const std::vector<int>& frames, const std::vector<int>& reviewed,
                   PassSource& source, const PassOptions& options, std::stop_token stop = {},
                   const PassProgress& progress = {}, const PassSink& sink = {});

} // namespace core
