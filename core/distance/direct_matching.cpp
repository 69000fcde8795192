// SPDX-License-Identifier: MIT
#include "core/distance/direct_matching.h"

#include <cmath>
#include <limits>

#include "core/distance/circular_distance.h"

namespace core {

namespace {

/// The index with the smallest finite cost.
template <typename Cost>
std::optional<DirectMatch> cheapest(const OrientedContour& contour, const Cost& cost) {
    DirectMatch best{-1, std::numeric_limits<double>::infinity()};
    for (int i = 0; i < static_cast<int>(contour.size()); ++i) {
        const double candidate = cost(i);
        if (candidate < best.distancePx)
            best = {i, candidate};
    }
    return best.index < 0 ? std::nullopt : std::optional(best);
}

} // namespace

double distancePx(const OrientedContour& contour, int index, const Eigen::Vector2d& px) {
    const auto i = static_cast<std::size_t>(index);
    const double dx = px.x() - contour.x[i];
    const double dy = px.y() - contour.y[i];
    return std::sqrt(dx * dx + dy * dy);
}

std::optional<DirectMatch> nearestPoint(const OrientedContour& contour, const Eigen::Vector2d& px) {
    return cheapest(
        contour, [&](int i) { return distancePx(contour, i, px); });
}

std::optional<DirectMatch> nearestPointInBin(const OrientedContour& contour, const OrientationBins& bins, int bin,
                                             const Eigen::Vector2d& px) {
    return cheapest(
        contour,
        [&](int i) {
            const bool inBin = bins.binOf(contour.angleRad[static_cast<std::size_t>(i)]) == bin;
            return inBin ? distancePx(contour, i, px) : std::numeric_limits<double>::infinity();
        });
}

std::optional<DirectMatch> nearestOrientedPoint(const OrientedContour& contour, const Eigen::Vector2d& px,
                                                double angleRad, double lambdaPxPerRad, bool isSigned) {
    return cheapest(
        contour,
        [&](int i) {
            const double contourAngleRad = contour.angleRad[static_cast<std::size_t>(i)];
            return distancePx(contour, i, px) + lambdaPxPerRad * circularDistance(angleRad, contourAngleRad, isSigned);
        });
}

std::optional<DirectMatch> nearestQuantisedPoint(const OrientedContour& contour, const OrientationBins& bins,
                                                 const Eigen::Vector2d& px, int bin, double lambdaPxPerRad) {
    return cheapest(
        contour,
        [&](int i) {
            const int contourBin = bins.binOf(contour.angleRad[static_cast<std::size_t>(i)]);
            return distancePx(contour, i, px) + lambdaPxPerRad * bins.distanceRad(bin, contourBin);
        });
}

} // namespace core
