// SPDX-License-Identifier: MIT
#include "core/distance/distance_transform.h"

#include <cmath>

#include "core/distance/direct_matching.h"
#include "core/distance/envelope.h"
#include "core/distance/grid_sites.h"

namespace core {

namespace {

DistanceTransform transformOf(const std::vector<GridSite>& sites, const cv::Rect& region) {
    const auto cols = static_cast<std::size_t>(region.width);
    const auto pixels = cols * static_cast<std::size_t>(region.height);
    DistanceTransform transform{region, std::vector<float>(pixels), std::vector<int>(pixels)};
    const ColumnDistances columns = nearestInColumns(sites, region.size());
    RowEnvelope envelope(region.width);
    for (int row = 0; row < region.height; ++row) {
        const std::size_t offset = static_cast<std::size_t>(row) * cols;
        envelope.run(columns, row, transform.distancePx.data() + offset, transform.nearest.data() + offset);
    }
    return transform;
}

} // namespace

DistanceTransform computeDistanceTransform(const OrientedContour& contour, const cv::Rect& region) {
    return transformOf(gridSites(contour, region), region);
}

std::vector<DistanceTransform> computeBinTransforms(const OrientedContour& contour, const OrientationBins& bins,
                                                    const cv::Rect& region) {
    std::vector<DistanceTransform> transforms;
    for (const std::vector<GridSite>& sites : gridSitesByBin(contour, bins, region))
        transforms.push_back(transformOf(sites, region));
    return transforms;
}

namespace {

/// What the transform says of the pixel nearest to px; what `direct` says if that lies outside the region.
template <typename Direct>
std::optional<DirectMatch> lookedUp(const DistanceTransform& transform, const OrientedContour& contour,
                                    const Eigen::Vector2d& px, const Direct& direct) {
    const int x = static_cast<int>(std::lround(px.x()));
    const int y = static_cast<int>(std::lround(px.y()));
    if (!transform.contains(x, y))
        return direct();
    const int nearest = transform.nearest[transform.at(x, y)];
    if (nearest < 0)
        return std::nullopt;
    return DirectMatch{nearest, distancePx(contour, nearest, px)};
}

} // namespace

std::optional<DirectMatch> nearestFromTransform(const DistanceTransform& transform, const OrientedContour& contour,
                                                const Eigen::Vector2d& px) {
    return lookedUp(
        transform, contour, px, [&] { return nearestPoint(contour, px); });
}

std::optional<DirectMatch> nearestFromBinTransforms(const std::vector<DistanceTransform>& transforms,
                                                    const OrientedContour& contour, const OrientationBins& bins,
                                                    int bin, const Eigen::Vector2d& px) {
    return lookedUp(
        transforms[static_cast<std::size_t>(bin)], contour, px,
        [&] { return nearestPointInBin(contour, bins, bin, px); });
}

} // namespace core
