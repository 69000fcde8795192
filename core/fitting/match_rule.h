// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "core/contour/visible_rim.h"
#include "core/distance/contour_index.h"
#include "core/fitting/fit_target.h"
#include "core/fitting/method.h"

namespace core {

/// How a rim point finds its contour point, with every default of the method filled in.
struct MatchRule {
    enum class Search {
        Nearest,     ///< on position only (CH); with a finite tauRad: match first, then reject (DCH-Thres)
        InBin,       ///< nearest in the own orientation bin (DCH-Quant)
        InTwoBins,   ///< nearest in each of the two nearest bins (DCH-Quant2)
        Directional, ///< least |p - q| + lambda circ(phi_p, phi_q) (DCH-DT3)
        WithinTau    ///< nearest among those within tauRad
    };
    Search search = Search::Nearest;
    float tauRad = std::numeric_limits<float>::infinity();
    float gatePx = std::numeric_limits<float>::infinity();
    float lambdaPxPerRad = 0;
    float truncatePx2 = 0; ///< K of the truncated penalty; farther matches exert no pull; 0 = none
    bool binWeights = false;
    bool wholePixels = false;
    OrientationBins bins{16, true};
};

/// The rule of one of the paper's methods. For `best` use its own phases.
MatchRule matchRule(const Method& method);

/// A contour point and its weight.
struct WeightedMatch {
    int index;
    float weight;
};

/// Appends the matches of one rim point (none, one or two).
void findMatches(const CameraTarget& target, const MatchRule& rule, const RimPoint& rim,
                 std::vector<WeightedMatch>& matches);

} // namespace core
