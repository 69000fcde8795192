// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/distance/distance_kind.h"

namespace core {

/// Where DCH-DT3 looks up its matches: both give the same ones.
enum class Dt3Backend { Direct, Tensor };
/// Paper: every iteration moves all degrees of freedom. RigidFirst: the first iterations move each hand as a whole.
/// core/fitting/phases.h has both.
enum class Schedule { RigidFirst, Paper };

/// What a silhouette shows beyond the end of a hand model. Cut: such contour takes no part. Ignore: it is contour as
/// any.
enum class Forearm { Cut, Ignore };

/// What `best` adds to DCH-Thres, each part an option of its own, so that its effect can be measured (`best:prior=0`).
/// Those that are off by default were tried and cost more than they bring.
struct BestOptions {
    bool live = false;      ///< the real-time variant: fewer iterations on coarser levels of the mesh
    bool palm = true;       ///< the palm is placed before the fingers move
    bool coarse = true;     ///< coarse levels of the mesh first; else the full mesh in every iteration
    bool wide = true;       ///< tau anneals from 45 deg to 22.5; else 22.5 deg in every iteration
    bool across = true;     ///< the distance along the outline counts a tenth: rims may slide
    bool prior = true;      ///< a weak pull of the angles to those of the start
    bool learnt = true;     ///< the pull knows how fingers move together (needs prior and noise)
    bool restarts = true;   ///< other starts where silhouettes are left unexplained
    bool apart = true;      ///< fingers and hands do not penetrate each other on the way from other starts (not live)
    bool polish = true;     ///< the last iterations on the full mesh
    bool bothWays = false;  ///< contour points pull the nearest rim points, too
    bool withinTau = false; ///< only contour points within tau are searched; else the nearest is found, then rejected
    double robustMm = 0;    ///< Cauchy scale of the distance, mm; 0 = none
    bool operator==(const BestOptions&) const = default;
};

/// A method with all its options: a directional distance, how its matches are found, and the schedule of the solver.
/// core/fitting/method_options.h lists the options of a method's name: `dch-thres:tau=22.5:signed=1`.
struct Method {
    DistanceKind distance = DistanceKind::DchThres;
    std::optional<BestOptions> best = std::nullopt; ///< set: our own method over DCH-Thres
    double tauDeg = 22.5;                           ///< tau, Thres only
    bool signedOrientation = true;                  ///< circ is signed, in [0, pi]; else unsigned, in [0, pi/2]
    double lambdaPxPerRad = 25;                     ///< lambda, DT3 only
    int bins = 0;                                   ///< 0 = the distance's default: Quant and Quant2 8, DT3 16
    double binCentre = 0;                           ///< offset of the bins' centres from the x axis, in bins, [0, 1)
    bool binWeights = false;        ///< Quant2 only: weighs the two matches by how near their bin centres are
    double gatePx = 0;              ///< 0 = the distance's default: Quant and Quant2 60, the others none
    double truncatePx2 = 0;         ///< K of the truncated penalty min(d^2, K), px^2; 0 = none
    double polygonEpsilonPx = 1.25; ///< approxPolyDP's epsilon for phi(q)
    bool chordTangent = false;      ///< phi(q) from a +-7 px chord instead of the polygon
    int maxIterations = 25;
    double damping = 1e-3; ///< relative to diag(H)
    Schedule schedule = Schedule::RigidFirst;
    Dt3Backend backend = Dt3Backend::Direct;
    Forearm forearm = Forearm::Cut;
    bool noise = true; ///< what counts as a difference is relative to the contour's noise
    bool operator==(const Method&) const = default;
};

} // namespace core
