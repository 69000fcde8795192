// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/contour/visible_rim.h"
#include "core/fitting/fit_target.h"
#include "core/hand/skinned_surface.h"
#include "core/subject/subject_problem.h"

namespace core {

struct OutlineMatching {
    int pointsPerCamera = 150;
    double gatePx = 30;
    double share = 0.25; ///< factor on all weights: neighbours on an outline are not independent
};

/// Matches the rims of posed hands to the outlines that cameras saw, by DCH-Thres. What lies beyond the wrist takes no
/// part.
class OutlineMatcher {
public:
    /// `hands` are shapes of the `spaces`' models, parallel to them.
    OutlineMatcher(const std::vector<ShapeSpace>& spaces, const std::vector<HandModel>& hands);

    /// Appends the matches of one frame; a hand with an empty pose is not there. Weights are 0 until weighOutline.
    void match(const HandPoses& poses, const std::vector<Camera>& cameras, const std::vector<CameraTarget>& outlines,
               int frame, const OutlineMatching& matching, std::vector<OutlineMatch>& matches);

private:
    /// A hand as rims see it, and which vertex of the mesh each vertex of the full level is.
    struct RimHand {
        SkinnedSurface full, cover;
        PosedPoints fullPosed, coverPosed;
        std::vector<int> meshVertex;
        std::vector<bool> leftOut; ///< per mesh vertex
    };
    OutlineMatch outlineMatch(const RimPoint& rim, std::size_t hand, const CameraTarget& target, int contourPoint,
                              int frame) const;

    std::vector<RimHand> m_rims;
    std::vector<Skeleton> m_skeletons;
    RimScratch m_scratch;
};

/// Gives every match its weight from the robust scale (1.48 median |residual|) of the residuals in these poses, and
/// Tukey's factor: zero beyond 4 of it. Returns the scale in mm; 0 without matches.
double weighOutline(const std::vector<double>& residualsMm, double share, std::vector<OutlineMatch>& matches);

/// Per vertex, whether it lies beyond the wrist: past the root's origin seen from the knuckles, or carried by the
/// forearm.
std::vector<bool> beyondWrist(const HandModel& model);

} // namespace core
