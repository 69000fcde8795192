// SPDX-License-Identifier: MIT
#pragma once

namespace core {

/// d(p, q) of a rim point p and a contour point q, and which matches are kept: the special cases of the generalized
/// Chamfer distance (Tzionas and Gall 2013, section 3; docs/method.md). phi is the direction of the outward normal,
/// circ the circular distance.
enum class DistanceKind {
    Ch,        ///< CH: |p - q|, all are kept
    DchThres,  ///< DCH-Thres: |p - q|, kept if circ(phi_p, phi_q) < tau
    DchQuant,  ///< DCH-Quant: |p - q| within the orientation bin of p, infinite elsewhere
    DchQuant2, ///< DCH-Quant2: the same within each of the two bins nearest to phi_p, two matches per point
    DchDt3     ///< DCH-DT3: |p - q| + lambda circ(phi_p, phi_q) with both directions quantised, all are kept
};

} // namespace core
