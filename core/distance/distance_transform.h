// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include "core/contour/oriented_contour.h"
#include "core/distance/direct_matching.h"
#include "core/distance/orientation_bins.h"

namespace core {

/// For every pixel of `region`, how far the nearest contour point is and which one it is.
/// Both grids are region.height x region.width, row = y - region.y. Distances in pixels between pixel centres; infinity
/// and -1 where the contour is empty.
struct DistanceTransform {
    cv::Rect region;
    std::vector<float> distancePx;
    std::vector<int> nearest;

    bool contains(int x, int y) const { return region.contains(cv::Point(x, y)); }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y - region.y) * static_cast<std::size_t>(region.width) +
               static_cast<std::size_t>(x - region.x);
    }
};

/// Exact Euclidean transform with argmin, O(pixels) (Felzenszwalb and Huttenlocher 2012; the integer form of Meijster,
/// Roerdink and Hesselink 2000): no floating point decides. Contour points count at their nearest pixel; those outside
/// the region are left out. Ties go to the smaller contour index.
DistanceTransform computeDistanceTransform(const OrientedContour& contour, const cv::Rect& region);

/// One transform per orientation bin, each of the contour points in that bin alone; empty bins are infinite.
/// Indices are those of the whole contour.
std::vector<DistanceTransform> computeBinTransforms(const OrientedContour& contour, const OrientationBins& bins,
                                                    const cv::Rect& region);

/// The contour point that the transform names for the pixel nearest to `px`, with its distance from `px` itself: at
/// most sqrt(2) px farther than the nearest one. Outside the region: all points are searched, which is slower and
/// exact. Empty if the transform holds no point.
std::optional<DirectMatch> nearestFromTransform(const DistanceTransform& transform, const OrientedContour& contour,
                                                const Eigen::Vector2d& px);
/// The same, from the transform of one bin; outside the region the points of that bin are searched.
std::optional<DirectMatch> nearestFromBinTransforms(const std::vector<DistanceTransform>& transforms,
                                                    const OrientedContour& contour, const OrientationBins& bins,
                                                    int bin, const Eigen::Vector2d& px);

} // namespace core
