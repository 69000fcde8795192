// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/fitting/fit_target.h"
#include "core/subject/subject_problem.h"

namespace core {

struct OutlineMatching {
    int pointsPerCamera = 150;
    double gatePx = 30;
    double share = 0.25; ///< factor on all weights: neighbours on an outline are not independent
};

/// The rims of shaped hands in one frame's poses, matched to its outlines by DCH-Thres. `hands` are parallel to
/// `spaces`. Weights are 0 until weighOutline.
void matchOutlines(const std::vector<ShapeSpace>& spaces, const std::vector<HandModel>& hands, const HandPoses& poses,
                   const std::vector<Camera>& cameras, const std::vector<CameraTarget>& outlines, int frame,
                   const OutlineMatching& matching, std::vector<OutlineMatch>& matches);

/// Gives every match its weight from the robust scale (1.48 median |residual|) of the residuals in these poses, and
/// Cauchy's factor. Returns the scale in mm; 0 without matches.
double weighOutline(const std::vector<double>& residualsMm, double share, std::vector<OutlineMatch>& matches);

/// Per vertex, whether it lies beyond the wrist: past the root's origin seen from the knuckles, or carried by the
/// forearm.
std::vector<bool> beyondWrist(const HandModel& model);

} // namespace core
