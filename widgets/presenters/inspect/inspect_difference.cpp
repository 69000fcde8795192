// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_difference.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"

namespace widgets {

namespace {

constexpr QRgb kMissed = 0xD0CC3C28; ///< premultiplied, as all of these
constexpr QRgb kExtra = 0xD0285ACC;
constexpr QRgb kLeftOut = 0xD0AAAAAA, kBetweenHatches = 0x40303030;
constexpr int kHatch = 6, kHatchWidth = 2; ///< of the diagonal lines, pixels of the picture

/// Not 0 where a pixel's centre lies in a region.
cv::Mat regionsMask(const std::vector<core::ConvexRegion>& regions, cv::Size size) {
    cv::Mat mask = cv::Mat::zeros(size, CV_8U);
    for (const core::ConvexRegion& region : regions) {
        for (int y = 0; y < size.height; ++y) {
            const auto span = region.span(static_cast<float>(y));
            if (!span)
                continue;
            const int first = std::max(0, static_cast<int>(std::ceil(span->first)));
            const int last = std::min(size.width - 1, static_cast<int>(std::floor(span->second)));
            if (first <= last)
                mask.row(y).colRange(first, last + 1).setTo(255);
        }
    }
    return mask;
}

QRgb pixel(bool isSeen, bool isCovered, bool isOut, int x, int y) {
    if (isOut && (isSeen || isCovered))
        return (x + y) % kHatch < kHatchWidth ? kLeftOut : kBetweenHatches;
    if (isOut || isSeen == isCovered)
        return 0;
    return isSeen ? kMissed : kExtra;
}

} // namespace

SilhouetteDifference silhouetteDifference(const core::Camera& camera, const cv::Mat& observed, const MeshLayer& posed,
                                          const std::vector<core::ConvexRegion>& leftOut) {
    std::vector<core::PosedSurface> surfaces;
    for (const ViewSurfacePtr& surface : posed.surfaces)
        surfaces.push_back({&surface->verticesInWorld, &surface->triangles});
    const cv::Mat mine = core::renderMask(camera, surfaces);
    SilhouetteDifference difference;
    if (mine.size() != observed.size())
        return difference;
    const cv::Mat seen = observed != 0, covered = mine != 0, out = regionsMask(leftOut, seen.size());
    const cv::Mat counted = out == 0;
    const int both = cv::countNonZero(seen & covered & counted), either = cv::countNonZero((seen | covered) & counted);
    difference.iou = either > 0 ? static_cast<double>(both) / either : std::numeric_limits<double>::quiet_NaN();
    difference.leftOutPx = cv::countNonZero((seen | covered) & out);
    QImage picture((seen.cols + 1) / 2, (seen.rows + 1) / 2, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < picture.height(); ++y) {
        const auto* seenRow = seen.ptr<unsigned char>(2 * y);
        const auto* coveredRow = covered.ptr<unsigned char>(2 * y);
        const auto* outRow = out.ptr<unsigned char>(2 * y);
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x)
            row[x] = pixel(seenRow[2 * x] != 0, coveredRow[2 * x] != 0, outRow[2 * x] != 0, x, y);
    }
    difference.picture = picture;
    return difference;
}

QColor missedColour() {
    return QColor::fromRgb(qUnpremultiply(kMissed));
}

QColor extraColour() {
    return QColor::fromRgb(qUnpremultiply(kExtra));
}

QColor leftOutColour() {
    return QColor::fromRgb(qUnpremultiply(kLeftOut));
}

} // namespace widgets
