// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/inspect_field.h"

#include <algorithm>
#include <array>

#include <opencv2/core.hpp>

#include "core/distance/generalized_chamfer.h"

namespace widgets {

namespace {

constexpr int kReduction = 4; ///< the picture has a quarter of the image's resolution
constexpr double kRefusedCost = 1e6;
constexpr double kShortestArrowPx = 4;
const QColor kArrow(0xFF, 0xFF, 0xFF, 0xA0);

core::DirectionalDistance reducedDistance(const core::MatchRule& rule) {
    core::DirectionalDistance distance;
    distance.kind = rule.distance;
    distance.tauRad = static_cast<double>(rule.tauRad);
    distance.isSigned = rule.bins.isSigned();
    distance.bins = rule.bins.count();
    distance.lambdaPxPerRad = static_cast<double>(rule.lambdaPxPerRad) / kReduction;
    distance.gatePx = static_cast<double>(rule.gatePx) / kReduction;
    return distance;
}

/// The scale in 256 steps, for pictures.
std::array<QRgb, 256> stepsOf(const FieldScale& scale) {
    std::array<QRgb, 256> colours{};
    for (std::size_t i = 0; i < colours.size(); ++i)
        colours[i] = scale.colour(static_cast<double>(i) / (colours.size() - 1)).rgba();
    return colours;
}

/// CV_32F, pixels of the image, kRefusedCost and more where the method would refuse.
cv::Mat reducedField(const core::CameraTarget& target, const core::MatchRule& rule, const core::Camera& camera,
                     double angleRad) {
    core::OrientedContour reduced = target.contour;
    for (std::size_t q = 0; q < reduced.size(); ++q) {
        reduced.x[q] /= kReduction;
        reduced.y[q] /= kReduction;
    }
    const cv::Rect region(0, 0, camera.size.width / kReduction, camera.size.height / kReduction);
    return kReduction * core::chamferField(reduced, reducedDistance(rule), {core::PenaltyKind::Absolute, kRefusedCost},
                                           region, angleRad);
}

QImage fieldPicture(const cv::Mat& cost, const FieldScale& scale) {
    const std::array<QRgb, 256> colours = stepsOf(scale);
    QImage picture(cost.cols, cost.rows, QImage::Format_ARGB32_Premultiplied);
    picture.fill(0);
    for (int y = 0; y < cost.rows; ++y) {
        const auto* from = cost.ptr<float>(y);
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < cost.cols; ++x)
            if (static_cast<double>(from[x]) < kRefusedCost)
                row[x] = colours[static_cast<std::size_t>(
                    std::clamp(static_cast<double>(from[x]) / scale.mostPx, 0.0, 1.0) * (colours.size() - 1) + 0.5)];
    }
    return picture;
}

/// The contour points are those of the method itself, at full resolution.
void addArrows(const cv::Mat& cost, const core::CameraTarget& target, const core::MatchRule& rule, float angleRad,
               double mostPx, OverlayShapes& shapes) {
    OverlayShapes::Dots ends;
    ends.colour = kArrow;
    constexpr int kStep = kFieldArrowStepPx / kReduction;
    for (int y = kStep / 2; y < cost.rows; y += kStep) {
        for (int x = kStep / 2; x < cost.cols; x += kStep) {
            if (static_cast<double>(cost.at<float>(y, x)) > mostPx)
                continue;
            const Eigen::Vector2f from(static_cast<float>(x * kReduction), static_cast<float>(y * kReduction));
            const core::ContourProbe probe = core::probeContour(target, rule, from, angleRad);
            if (probe.contourPoint < 0 || probe.verdict != core::MatchVerdict::Kept ||
                probe.distancePx < kShortestArrowPx)
                continue;
            const Eigen::Vector2f to = core::contourPx(target, probe.contourPoint);
            ends.px.emplace_back(static_cast<double>(to.x()), static_cast<double>(to.y()));
            shapes.lines.push_back({QPointF(x * kReduction, y * kReduction), ends.px.back(), kArrow});
        }
    }
    shapes.dots.push_back(std::move(ends));
}

} // namespace

FieldOverlay fieldOverlay(const core::CameraTarget& target, const core::MatchRule& rule, const core::Camera& camera,
                          double angleRad, const FieldScale& scale) {
    const cv::Mat cost = reducedField(target, rule, camera, angleRad);
    FieldOverlay overlay;
    overlay.picture = fieldPicture(cost, scale);
    addArrows(cost, target, rule, static_cast<float>(angleRad), scale.mostPx, overlay.arrows);
    return overlay;
}

} // namespace widgets
