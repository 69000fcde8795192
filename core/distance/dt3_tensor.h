// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/types.hpp>

#include "core/contour/oriented_contour.h"
#include "core/distance/direct_matching.h"
#include "core/distance/orientation_bins.h"

namespace core {

/// For every pixel of `region` and every orientation bin, the contour point that minimises |p - q| + lambda * circ over
/// quantised orientations (DT3 of Liu, Tuzel, Veeraraghavan and Chellappa, CVPR 2010). Only the argmin is kept, two
/// bytes each: nearest[(bin * height + row) * width + column]; kNone where the contour is empty.
struct Dt3Tensor {
    static constexpr std::uint16_t kNone = 0xFFFF;

    OrientationBins bins;
    double lambdaPxPerRad;
    cv::Rect region;
    std::vector<std::uint16_t> nearest;

    bool contains(int x, int y) const { return region.contains(cv::Point(x, y)); }
    std::size_t at(int bin, int x, int y) const {
        const auto width = static_cast<std::size_t>(region.width);
        const auto height = static_cast<std::size_t>(region.height);
        const auto row = static_cast<std::size_t>(y - region.y);
        return (static_cast<std::size_t>(bin) * height + row) * width + static_cast<std::size_t>(x - region.x);
    }
};

/// Exact transforms per bin, then relaxation around the circle of bins: 1.5 laps forward and 1.5 back, so that every
/// bin is reached from every other one in both directions; distance and argmin travel together. Contour points count at
/// their nearest pixel, those outside the region are left out. Throws Error(Unsupported) if the contour has 65535
/// points or more.
Dt3Tensor computeDt3Tensor(const OrientedContour& contour, const OrientationBins& bins, double lambdaPxPerRad,
                           const cv::Rect& region);

/// The contour point that the tensor names for the pixel nearest to `px` and the bin of `angleRad`; the distance is
/// |p - q| + lambda * circ from `px` itself, orientations quantised. Outside the region all points are searched.
std::optional<DirectMatch> nearestFromTensor(const Dt3Tensor& tensor, const OrientedContour& contour,
                                             const Eigen::Vector2d& px, double angleRad);

} // namespace core
