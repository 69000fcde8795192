// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "core/contour/visible_rim.h"
#include "core/distance/contour_index.h"
#include "core/distance/distance_kind.h"
#include "core/fitting/fit_target.h"
#include "core/fitting/fit_trace.h"
#include "core/fitting/method.h"

namespace core {

/// How a rim point p finds its contour point q, with every default of the method filled in. docs/method.md has the
/// equations.
struct MatchRule {
    /// Which q is taken, and whether the match is kept.
    DistanceKind distance = DistanceKind::DchThres;
    float tauRad = std::numeric_limits<float>::infinity(); ///< DchThres: kept if circ(phi_p, phi_q) < tau
    /// DchThres: q = argmin |p - q| over those with circ(phi_p, phi_q) < tau, instead of over all with a rejection
    /// afterwards.
    bool withinTau = false;
    float lambdaPxPerRad = 0;                              ///< DchDt3: d = |p - q| + lambda circ(phi_p, phi_q)
    float gatePx = std::numeric_limits<float>::infinity(); ///< matches with |p - q| above it are not made
    float truncatePx2 = 0;    ///< K of min(|p - q|^2, K): farther matches have no gradient and are dropped; 0 = none
    bool binWeights = false;  ///< DchQuant2: weight 1 - circ(phi_p, bin centre) / bin width; the two weights sum to 1
    bool wholePixels = false; ///< p is rounded to its pixel, as a distance transform does
    OrientationBins bins{16, true};
};

/// The rule of a method; for `best`, tau is that of its phases.
MatchRule matchRule(const Method& method);

/// A contour point and its weight.
struct WeightedMatch {
    int index;
    float weight;
};

/// Appends the matches of one rim point (none, one or two).
void findMatches(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim,
                 std::vector<WeightedMatch>& matches);

/// A contour point that a rule considered for a rim point; index -1 where no contour point qualifies.
struct MatchCandidate {
    int index;
    float weight; ///< 0 unless kept
    MatchVerdict verdict;
};

/// Appends what findMatches finds, in its order, and for what it refuses the contour point and the reason.
void explainMatches(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim,
                    std::vector<MatchCandidate>& candidates);

/// What a rule finds for a point of the image with a direction, as if the model's rim passed there.
struct ContourProbe {
    int contourPoint = -1; ///< q, an index into the contour; -1 where none qualifies
    int bin = 0;           ///< of the direction
    double distancePx = 0; ///< |p - q|; NaN without q
    double cost = 0;       ///< d(p, q) in px: |p - q|, for DCH-DT3 plus lambda circ; NaN without q
    MatchVerdict verdict = MatchVerdict::Kept;
};
/// The target must have been prepared for the rule's bins. With two candidates (Quant2), the nearer one.
ContourProbe probeContour(const CameraTarget& target, const MatchRule& rule, const Eigen::Vector2f& px, float angleRad);

/// The same contour prepared for another method's rule, without a tensor.
CameraTarget targetForRule(const CameraTarget& target, const MatchRule& rule);

} // namespace core
