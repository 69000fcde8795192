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

/// Not 0 where a pixel's centre lies in a region, of that window of the image.
cv::Mat regionsMask(const std::vector<core::ConvexRegion>& regions, const cv::Rect& window) {
    cv::Mat mask = cv::Mat::zeros(window.size(), CV_8U);
    for (const core::ConvexRegion& region : regions) {
        for (int y = 0; y < window.height; ++y) {
            const auto span = region.span(static_cast<float>(window.y + y));
            if (!span)
                continue;
            const int first = std::max(0, static_cast<int>(std::ceil(span->first)) - window.x);
            const int last = std::min(window.width - 1, static_cast<int>(std::floor(span->second)) - window.x);
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
    const cv::Rect window = cv::boundingRect(observed) | cv::boundingRect(mine); // nothing to tell apart around it
    const cv::Mat seen = observed(window) != 0, covered = mine(window) != 0, out = regionsMask(leftOut, window);
    const cv::Mat counted = out == 0;
    const int both = cv::countNonZero(seen & covered & counted), either = cv::countNonZero((seen | covered) & counted);
    difference.iou = either > 0 ? static_cast<double>(both) / either : std::numeric_limits<double>::quiet_NaN();
    difference.leftOutPx = cv::countNonZero((seen | covered) & out);
    QImage picture((observed.cols + 1) / 2, (observed.rows + 1) / 2, QImage::Format_ARGB32_Premultiplied);
    picture.fill(0);
    for (int y = (window.y + 1) / 2; 2 * y < window.br().y; ++y) {
        const auto* seenRow = seen.ptr<unsigned char>(2 * y - window.y);
        const auto* coveredRow = covered.ptr<unsigned char>(2 * y - window.y);
        const auto* outRow = out.ptr<unsigned char>(2 * y - window.y);
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = (window.x + 1) / 2; 2 * x < window.br().x; ++x) {
            const int from = 2 * x - window.x;
            row[x] = pixel(seenRow[from] != 0, coveredRow[from] != 0, outRow[from] != 0, x, y);
        }
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
