// SPDX-License-Identifier: MIT
#include "core/distance/grid_sites.h"

#include <cmath>

namespace core {

std::vector<GridSite> gridSites(const OrientedContour& contour, const cv::Rect& region) {
    std::vector<GridSite> sites;
    sites.reserve(contour.size());
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const cv::Point pixel(static_cast<int>(std::lround(contour.x[i])), static_cast<int>(std::lround(contour.y[i])));
        if (region.contains(pixel))
            sites.push_back({pixel.x - region.x, pixel.y - region.y, static_cast<int>(i)});
    }
    return sites;
}

std::vector<std::vector<GridSite>> gridSitesByBin(const OrientedContour& contour, const OrientationBins& bins,
                                                  const cv::Rect& region) {
    std::vector<std::vector<GridSite>> byBin(static_cast<std::size_t>(bins.count()));
    for (const GridSite& site : gridSites(contour, region)) {
        const double angleRad = contour.angleRad[static_cast<std::size_t>(site.index)];
        byBin[static_cast<std::size_t>(bins.binOf(angleRad))].push_back(site);
    }
    return byBin;
}

} // namespace core
