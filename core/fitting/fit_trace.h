// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/contour/forearm.h"
#include "core/fitting/fit_target.h"
#include "core/hand/hand_model.h"

namespace core {

/// Whether a rim point's contour point takes part in the step, and if not, why.
enum class MatchVerdict : std::uint8_t {
    Kept,
    Orientation, ///< the directions differ by tau or more
    Gate,        ///< the nearest that qualifies lies beyond the gate
    Truncated,   ///< |p - q|^2 is above K: no gradient
    EmptyBin,    ///< the outline has no point in the bin of the rim point's direction
    Forearm      ///< the rim point, or its contour point, lies beyond the end of the hand model
};
/// "" for kept, "orientation", "gate", "truncated", "empty_bin", "forearm"
std::string_view matchVerdictName(MatchVerdict verdict);

/// One rim point p of the posed hands and the contour point q that the solver found for it.
struct MatchRecord {
    static constexpr int kNoContourPoint = -1;
    static constexpr std::uint8_t kNoBone = 255;

    Eigen::Vector2f rimPx;              ///< p
    float rimAngleRad = 0;              ///< phi(p), atan2 of the outward image normal
    int contourPoint = kNoContourPoint; ///< q, an index into the camera's contour
    float weight = 0;                   ///< of the squared distance in the step; 0 unless kept
    MatchVerdict verdict = MatchVerdict::Kept;
    std::uint8_t hand = 0;
    std::uint8_t bone = kNoBone; ///< of the hand's skeleton: the one that moves p most
};

/// The matches of one iteration in one camera.
struct CameraMatches {
    int camera = 0; ///< index into the cameras
    std::vector<MatchRecord> matches;
    std::vector<ConvexRegion> leftOut; ///< of the picture: forearms, which take no part in the fit
};
/// Of all cameras that take part, in the order of FitTrace::targets.
using IterationMatches = std::vector<CameraMatches>;

/// What the solver saw: the very targets that it matched with, and the matches at the final pose.
struct FitTrace {
    std::vector<CameraTarget> targets;
    IterationMatches finalMatches;
    /// Per hand, where its forearm was cut off in the end; no value for hands without one. Empty: none was looked for.
    std::vector<std::optional<ForearmCut>> forearms;
};

/// Where the forearms of posed hands may be seen by a camera: those of hands with a cut, as far as they are in the
/// picture. cuts: one per hand.
std::vector<ConvexRegion> forearmRegions(const Camera& camera, const std::vector<HandModel>& hands,
                                         const HandPoses& poses, const std::vector<std::optional<ForearmCut>>& cuts);

/// A recorded match, spelled out: pixels, radians. Quantities of q are NaN where there is none.
struct MatchGeometry {
    Eigen::Vector2f contourPx;
    float contourAngleRad = 0;
    float residualPx = 0; ///< |p - q|
};
MatchGeometry matchGeometry(const MatchRecord& match, const OrientedContour& contour);

} // namespace core
