// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/contour/oriented_contour.h"
#include "core/distance/orientation_bins.h"

namespace core {

/// What a search found: an index into the contour and the distance d(p, q) that was minimised; index -1 if nothing.
struct ContourMatch {
    int index = -1;
    float distance = 0;
};

/// Exact nearest-point search over an oriented contour, for one camera: a uniform grid over the outline, searched in
/// growing rings until nothing nearer can follow. No set-up worth mentioning and no rounding to pixels, against the
/// distance transforms' fixed cost per pixel. Ties go to the smaller index.
class ContourIndex {
public:
    /// bins: how orientations are quantised for nearestInBin and nearestDirectional.
    ContourIndex(const OrientedContour& contour, const OrientationBins& bins);

    /// argmin |p - q|, within gatePx.
    ContourMatch nearest(float x, float y, float gatePx) const;
    /// argmin |p - q| over the contour points of one orientation bin (DCH-Quant).
    ContourMatch nearestInBin(float x, float y, int bin, float gatePx) const;
    /// argmin |p - q| over the points with circ(phi, phi_q) < tauRad.
    ContourMatch nearestWithin(float x, float y, float angleRad, float tauRad, float gatePx) const;
    /// argmin |p - q| + lambda * circ(bin, bin_q) (DCH-DT3); both orientations quantised, within gatePx of p.
    ContourMatch nearestDirectional(float x, float y, int bin, float lambdaPxPerRad, float gatePx) const;

private:
    static constexpr float kCellPx = 8;

    template <typename Cost>
    ContourMatch search(float x, float y, float gatePx, Cost&& costOf) const;

    OrientationBins m_bins;
    float m_originX = 0;
    float m_originY = 0;
    int m_columns = 0;
    int m_rows = 0;
    std::vector<int> m_firstInCell; ///< cells + 1
    std::vector<int> m_index;       ///< contour indices by cell, ascending in each
    std::vector<float> m_x, m_y, m_angle;
    std::vector<int> m_bin;
    std::vector<float> m_binDistance; ///< bins x bins, rad
};

} // namespace core
