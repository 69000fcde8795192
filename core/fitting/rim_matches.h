// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/contour/forearm.h"
#include "core/contour/visible_rim.h"
#include "core/fitting/fit_target.h"
#include "core/fitting/fit_trace.h"
#include "core/fitting/match_rule.h"
#include "core/fitting/ray_equations.h"

namespace core {

/// Levels of detail of all hands, coarse to fine.
inline constexpr int kSurfaceLevels = 3;
enum class Detail { Coarse = 0, Medium = 1, Full = 2 };

/// How one iteration is done.
struct IterationSettings {
    MatchRule rule;
    Detail detail = Detail::Full;
    int pointsPerCamera = 300;
    int contourPointsPerCamera = 0; ///< the other direction: contour points that pull the nearest rim point; 0 = none
    bool rigidOnly = false;         ///< only the six rigid degrees of freedom of each hand move
    double damping = 1e-3;          ///< relative to diag(H)
    double tangentWeight = 1;       ///< of the distance along the outline; 1 = the paper's full point-to-ray distance
    double robustMm = 0;            ///< Cauchy scale of the distance; 0 = none
    double robustPx = 0;            ///< Cauchy scale of the distance across the outline in the picture; 0 = none
    double startPrior = 0;          ///< weight of (angle - start angle)^2, mm^2 per rad^2 and correspondence
    double motionPrior = 0;         ///< weight of the Mahalanobis distance of the angles from the start's, mm^2 per
                                    ///< correspondence (core/hand/finger_prior.h)
    double overlapWeight = 0;       ///< of the squared depth, mm^2, by which bones penetrate each other,
                                    ///< per correspondence (core/hand/finger_overlap.h); 0 = they may
};

/// What the rim of one camera view was matched with; its memory is reused from iteration to iteration.
struct RimMatches {
    std::vector<std::vector<RayCorrespondence>> correspondences; ///< per hand
    int rejected = 0;                                            ///< rim points without a match
    bool recording = false;
    /// If recording, per hand: of every vertex of the surface, the bone that moves it most.
    std::span<const std::vector<std::uint8_t>> boneOfVertex;
    std::vector<MatchRecord> records; ///< if recording: what was kept and what was refused
    std::vector<WeightedMatch> matches;
    std::vector<MatchCandidate> candidates;
};

/// Of every vertex, the bone that moves it most.
std::vector<std::uint8_t> strongestBones(const SkinnedSurface& surface);

/// Removes what lies in a region that is left out, such as a forearm, from the rim; recorded as such.
void leaveOut(std::span<const ConvexRegion> regions, std::vector<RimPoint>& rim, RimMatches& result);

/// Matches the rim by the settings' rule, and the contour with the rim where the settings ask for it. What lies in a
/// `leftOut` region takes no part. Replaces the correspondences and the count; adds to the records.
void matchRim(const CameraTarget& target, const IterationSettings& settings, const std::vector<RimPoint>& rim,
              std::span<const ConvexRegion> leftOut, RimMatches& result);

/// How far the contour point lies from the rim point, across the outline, px.
double acrossPx(const RimPoint& rim, const CameraTarget& target, int contourPoint);

/// True if a region contains the pixel.
bool isInside(std::span<const ConvexRegion> regions, const Eigen::Vector2f& px);

} // namespace core
