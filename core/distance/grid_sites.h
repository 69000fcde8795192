// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "core/contour/oriented_contour.h"
#include "core/distance/orientation_bins.h"

namespace core {

/// A point that a distance transform measures to: its pixel, relative to the region, and its number.
struct GridSite {
    int x = 0;
    int y = 0;
    int index = 0;
};

/// The contour points at their nearest pixels; those outside the region are left out.
std::vector<GridSite> gridSites(const OrientedContour& contour, const cv::Rect& region);
/// The same, one list per orientation bin.
std::vector<std::vector<GridSite>> gridSitesByBin(const OrientedContour& contour, const OrientationBins& bins,
                                                  const cv::Rect& region);

} // namespace core
