// SPDX-License-Identifier: MIT
#include "core/contour/sleeve.h"

#include <optional>

namespace core {

namespace {

constexpr double kNearestMm = 50; ///< of what is projected to the camera
constexpr double kSliceMm = 4;
constexpr double kBesideMm = 3.5; ///< more than another person's wrist or a calibration explains on both sides
constexpr double kWidestMm = 45;  ///< half of a wrist; wider is something else
constexpr double kWalkPx = 2;
constexpr int kFewestPlaces = 6;
constexpr double kSleeveShare = 0.7;

bool isInPicture(const cv::Mat& mask, const Eigen::Vector2d& px) {
    return (px.array() >= 0).all() && px.x() <= mask.cols - 1 && px.y() <= mask.rows - 1;
}

/// From a covered pixel in a direction, the first place that is not covered and a margin beyond it; none if it is too
/// far.
std::optional<Eigen::Vector2d> placeBeside(const CoverageMask& coverage, const Eigen::Vector2d& from,
                                           const Eigen::Vector2d& direction, double pxPerMm) {
    for (double walked = 0; walked < kWidestMm * pxPerMm; walked += kWalkPx) {
        if (!coverage.covers((from + walked * direction).cast<float>())) {
            const Eigen::Vector2d place = from + (walked + kBesideMm * pxPerMm) * direction;
            return coverage.covers(place.cast<float>()) ? std::nullopt : std::optional(place);
        }
    }
    return std::nullopt;
}

} // namespace

void SleeveSearch::look(const Camera& camera, const ForearmCut& cut, const RigidMotion& worldFromRest,
                        const CoverageMask& coverage, const cv::Mat& mask) {
    for (int slice = 0; slice < kSlices; ++slice) {
        const Eigen::Vector3d point = worldFromRest * (cut.centre - slice * kSliceMm * cut.direction);
        const double depthMm = (camera.cameraFromWorld * point).z();
        const auto px = depthMm > kNearestMm ? project(camera, point) : std::nullopt;
        const auto next =
            px ? project(camera, worldFromRest * (cut.centre - (slice + 1) * kSliceMm * cut.direction)) : std::nullopt;
        if (!next || !coverage.covers(px->cast<float>()))
            continue;
        const double pxPerMm = camera.intrinsics(0, 0) / depthMm;
        const Eigen::Vector2d along = *next - *px;
        if (along.norm() < 0.5 * kSliceMm * pxPerMm) // looked at from its end
            continue;
        const Eigen::Vector2d side = Eigen::Vector2d(-along.y(), along.x()).normalized();
        for (const Eigen::Vector2d& direction : {side, Eigen::Vector2d(-side)}) {
            const auto place = placeBeside(coverage, *px, direction, pxPerMm);
            if (!place || !isInPicture(mask, *place))
                continue;
            ++m_places[static_cast<std::size_t>(slice)];
            m_foreground[static_cast<std::size_t>(slice)] +=
                mask.at<unsigned char>(static_cast<int>(place->y()), static_cast<int>(place->x())) != 0;
        }
    }
}

double SleeveSearch::beginsMm() const {
    int slices = 0;
    for (std::size_t slice = 0; slice < kSlices; ++slice, ++slices)
        if (m_places[slice] < kFewestPlaces || m_foreground[slice] < kSleeveShare * m_places[slice])
            break;
    return slices * kSliceMm;
}

} // namespace core
