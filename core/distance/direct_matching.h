// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/contour/oriented_contour.h"
#include "core/distance/orientation_bins.h"

namespace core {

/// A contour point that belongs to a query point. `distance` is what was minimised: pixels, plus the orientation's part
/// where orientation counts.
struct DirectMatch {
    int index = 0;
    double distancePx = 0;
};

// Exact matching of one query point by looking at every contour point: no set-up, any position, no grid. Ties go to the
// smaller index. Empty where no contour point qualifies.

/// Distance between a contour point and a pixel position.
double distancePx(const OrientedContour& contour, int index, const Eigen::Vector2d& px);

/// The nearest contour point.
std::optional<DirectMatch> nearestPoint(const OrientedContour& contour, const Eigen::Vector2d& px);

/// The nearest contour point among those of one orientation bin.
std::optional<DirectMatch> nearestPointInBin(const OrientedContour& contour, const OrientationBins& bins, int bin,
                                             const Eigen::Vector2d& px);

/// The contour point q that minimises |p - q| + lambda * circ(phi_p, phi_q), lambda in px per rad.
std::optional<DirectMatch> nearestOrientedPoint(const OrientedContour& contour, const Eigen::Vector2d& px,
                                                double angleRad, double lambdaPxPerRad, bool isSigned);

/// The same with both orientations quantised to the centres of their bins, as a DT3 tensor does.
std::optional<DirectMatch> nearestQuantisedPoint(const OrientedContour& contour, const OrientationBins& bins,
                                                 const Eigen::Vector2d& px, int bin, double lambdaPxPerRad);

} // namespace core
