// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace core {

/// Special cases of the generalized Chamfer distance (Tzionas and Gall 2013, section 3), and our own method.
enum class MethodKind { Ch, DchThres, DchQuant, DchQuant2, DchDt3, Best };

/// Where DCH-DT3 looks up its matches: both give the same ones.
enum class Dt3Backend { Direct, Tensor };
/// Paper: every iteration moves all degrees of freedom. RigidFirst, the default: the first 14 iterations move only the
/// six rigid ones of each hand, on coarser levels of the mesh; the last two fifths narrow the gate of Quant and Quant2
/// to 12 px.
enum class Schedule { RigidFirst, Paper };

/// The ideas that `best` is made of, each an option of its own, so that what it earns can be measured (`best:prior=0`).
/// Those that are off by default were tried and cost more than they bring.
struct BestIdeas {
    bool palm = true;        ///< the palm finds its place before the fingers move
    bool coarse = true;      ///< coarse levels of the mesh first; else the full mesh all the way
    bool wide = true;        ///< tau anneals from 45 deg to 22.5; else 22.5 deg all the way
    bool across = true;      ///< the distance along the outline counts a tenth: rims may slide
    bool prior = true;       ///< a weak pull of the angles to those of the start
    bool restarts = true;    ///< other starts where silhouettes are left unexplained
    bool polish = true;      ///< the last iterations on the full mesh
    bool bothWays = false;   ///< contour points pull the nearest rim points, too
    bool withinTau = false;  ///< only contour points within tau are searched; else the nearest is found, then rejected
    double robustMm = 0;     ///< Cauchy scale of the distance, mm; 0 = none
    bool operator==(const BestIdeas&) const = default;
};

/// A method with all its options. Every field is an option of the method's name: `dch-thres:tau=22.5:signed=1`.
struct Method {
    MethodKind kind = MethodKind::DchThres;
    double tauDeg = 22.5;          ///< tau, Thres only (paper: 22.5)
    bool signedOrientation = true; ///< signed: [0, pi]; else [0, pi/2] (paper: signed)
    double lambdaPxPerRad = 25;    ///< lambda, DT3 only (paper: 25)
    int bins = 0;                  ///< 0 = the method's default: Quant 8, DT3 16
    double binCentre = 0;    ///< centre=0.5: bins begin at the x axis instead of being centred on it (in bins, [0, 1))
    bool binWeights = false; ///< Quant2 only: weights=1 weighs the two matches by how near their bin centres are
    double gatePx = 0;       ///< 0 = the method's default: Quant and Quant2 60, the others none
    double truncatePx2 = 0;  ///< K of the truncated penalty min(d^2, K), px^2; 0 = none
    double polygonEpsilonPx = 1.25; ///< approxPolyDP's epsilon for phi(q)
    bool chordTangent = false;      ///< tangent=chord: phi(q) from a +-7 px chord instead of the polygon
    int maxIterations = 25;
    double damping = 1e-3; ///< relative to diag(H)
    Schedule schedule = Schedule::RigidFirst;
    Dt3Backend backend = Dt3Backend::Direct;
    bool live = false; ///< best only: the real-time variant
    BestIdeas ideas{}; ///< best only
    bool operator==(const Method&) const = default;
};

/// Parses `ch`, `dch-thres:tau=22.5:signed=1`, `best:live=1`, ... Throws Error(Usage) naming the option at fault.
Method parseMethod(std::string_view text);
/// The text as given on the command line: name and the options that differ from the default.
std::string methodName(const Method& method);
/// The six plain names, in the paper's order.
std::vector<std::string> plainMethodNames();

} // namespace core
