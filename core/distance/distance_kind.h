// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace core {

/// d(p, q) of a rim point p and a contour point q, and which matches are kept: the special cases of the generalized
/// Chamfer distance (Tzionas and Gall 2013, section 3; docs/method.md). phi is the direction of the outward normal,
/// circ the circular distance. kDistanceTraits says what each of them searches.
enum class DistanceKind {
    Ch,        ///< CH: |p - q|, all are kept
    DchThres,  ///< DCH-Thres: |p - q|, kept if circ(phi_p, phi_q) < tau
    DchQuant,  ///< DCH-Quant: |p - q| within the orientation bin of p, infinite elsewhere
    DchQuant2, ///< DCH-Quant2: the same within each of the two bins nearest to phi_p, two matches per point
    DchDt3     ///< DCH-DT3: |p - q| + lambda circ(phi_p, phi_q) with both directions quantised, all are kept
};

/// What distinguishes the search of one kind from that of another.
struct DistanceTraits {
    DistanceKind kind;
    int bins;        ///< nearest orientation bins that are searched, a match in each; 0: points of any orientation
    bool isLimited;  ///< circ(phi_p, phi_q) < tau decides which matches are kept
    bool isOriented; ///< orientation is part of the distance that is minimised
};

/// In the order of the kinds.
inline constexpr std::array<DistanceTraits, 5> kDistanceTraits{{{DistanceKind::Ch, 0, false, false},
                                                                {DistanceKind::DchThres, 0, true, false},
                                                                {DistanceKind::DchQuant, 1, false, false},
                                                                {DistanceKind::DchQuant2, 2, false, false},
                                                                {DistanceKind::DchDt3, 0, false, true}}};

constexpr const DistanceTraits& traitsOf(DistanceKind kind) {
    return kDistanceTraits[static_cast<std::size_t>(kind)];
}

} // namespace core
