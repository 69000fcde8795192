// SPDX-License-Identifier: MIT
#include "core/segmentation/model_seeds.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"

namespace core {

namespace {

constexpr double kLeastBandPx = 3;
constexpr double kShortestLinePx = 4;
constexpr double kEndReach = 1.5;   ///< around the model's end, in bands
constexpr double kThinBones = 0.35; ///< radius of what is surely in a finger, of the band

bool isPosed(const HandModel& hand, const Pose& pose) {
    return pose.size() == hand.skeleton.poseSize();
}

/// Pixels per mm at the hands, the largest.
double pixelsPerMm(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses) {
    double scale = 0;
    for (std::size_t h = 0; h < std::min(hands.size(), poses.size()); ++h) {
        if (!isPosed(hands[h], poses[h]))
            continue;
        for (const Eigen::Vector3d& joint : jointPositions(hands[h].skeleton, poses[h]))
            if (const double depth = (camera.cameraFromWorld * joint).z(); depth > 1)
                scale = std::max(scale, camera.intrinsics(0, 0) / depth);
    }
    return scale;
}

/// The silhouettes of those that are posed, whole.
cv::Mat silhouetteOf(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses) {
    std::vector<HandModel> posed;
    HandPoses theirs;
    for (std::size_t h = 0; h < std::min(hands.size(), poses.size()); ++h) {
        if (isPosed(hands[h], poses[h])) {
            posed.push_back(hands[h]);
            theirs.push_back(poses[h]);
        }
    }
    return renderHandsMask(camera, posed, theirs);
}

/// The inside that is left of thin fingers: the deepest line of what the band takes away whole.
cv::Mat deepestLines(const cv::Mat& depthPx, double bandPx) {
    cv::Mat highest;
    const int reach = 2 * static_cast<int>(std::ceil(bandPx / 2)) + 1;
    cv::dilate(depthPx, highest, cv::getStructuringElement(cv::MORPH_ELLIPSE, {reach, reach}));
    return (depthPx >= highest - 0.5F) & (depthPx > kThinBones * bandPx);
}

cv::Mat regionMask(const ConvexRegion& region, const cv::Rect& window) {
    cv::Mat mask = cv::Mat::zeros(window.size(), CV_8U);
    for (int y = 0; y < window.height; ++y) {
        const auto span = region.span(static_cast<float>(y + window.y));
        if (!span)
            continue;
        const int left = std::max(0, static_cast<int>(std::ceil(span->first)) - window.x);
        const int right = std::min(window.width - 1, static_cast<int>(std::floor(span->second)) - window.x);
        if (left <= right)
            mask.row(y).colRange(left, right + 1).setTo(255);
    }
    return mask;
}

/// 255 on the far side of a line, of the window's size.
cv::Mat farSide(const ForearmLine& line, const cv::Rect& window) {
    cv::Mat mask(window.size(), CV_8U);
    const Eigen::Vector2d from = line.from - Eigen::Vector2d(window.x, window.y);
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            mask.at<uchar>(y, x) = (Eigen::Vector2d(x, y) - from).dot(line.away) > 0 ? 255 : 0;
    return mask;
}

/// A line along an arm's axis, half as thick as the arm.
void drawAxis(cv::Mat& mask, const Camera& camera, const ForearmCut& cut, const RigidMotion& worldFromRest,
              const cv::Rect& window) {
    std::optional<cv::Point> last;
    for (const Eigen::Vector3d& point : forearmAxis(cut, worldFromRest)) {
        const double depthMm = (camera.cameraFromWorld * point).z();
        const auto px = depthMm > cut.radiusMm ? project(camera, point) : std::nullopt;
        if (!px || !isInside(camera.size, *px))
            return;
        const cv::Point at(cvRound(px->x()) - window.x, cvRound(px->y()) - window.y);
        const int thickness = std::max(1, cvRound(cut.radiusMm * camera.intrinsics(0, 0) / depthMm));
        cv::line(mask, last.value_or(at), at, cv::Scalar(255), thickness);
        last = at;
    }
}

/// An arm goes on beyond the model's end, without an edge there: the model says where the hand ends.
void addEnd(ModelInView& result, const Camera& camera, const HandModel& hand, const Pose& pose) {
    const std::optional<ForearmLine> line = modelEnd(camera, hand, pose);
    const ConvexRegion region = forearmRegion(camera, forearmCut(hand), worldFromRest(hand, pose));
    if (!line || region.empty())
        return;
    const cv::Mat beyond = regionMask(region, result.window) & farSide(*line, result.window);
    result.arms |= beyond & ~result.model;
    drawAxis(result.armCores, camera, forearmCut(hand), worldFromRest(hand, pose), result.window);
    result.cuts.push_back(*line);
}

} // namespace

std::optional<ForearmLine> modelEnd(const Camera& camera, const HandModel& hand, const Pose& pose) {
    const ForearmCut cut = forearmCut(hand);
    const RigidMotion motion = worldFromRest(hand, pose);
    const Eigen::Vector3d end = motion * (cut.centre + cut.endMm * cut.direction);
    const auto centre = project(camera, end);
    const auto beyond = project(camera, end + cut.radiusMm * (motion.rotation * cut.direction));
    if (!centre || !beyond || (*beyond - *centre).norm() < kShortestLinePx)
        return std::nullopt;
    const Eigen::Vector2d away = (*beyond - *centre).normalized();
    const double depthMm = (camera.cameraFromWorld * end).z();
    const double radiusPx = cut.radiusMm * camera.intrinsics(0, 0) / depthMm;
    const Eigen::Vector2d half = radiusPx * Eigen::Vector2d(-away.y(), away.x());
    return ForearmLine{*centre - half, *centre + half, away};
}

ModelInView modelInView(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses,
                        const ModelViewOptions& options) {
    ModelInView result;
    const double scale = pixelsPerMm(camera, hands, poses);
    if (scale <= 0)
        return result;
    const cv::Mat whole = silhouetteOf(camera, hands, poses);
    result.bandPx = std::max(kLeastBandPx, options.bandMm * scale);
    const int margin = static_cast<int>(std::ceil(result.bandPx + options.marginMm * scale));
    result.window = grownWindow(cv::boundingRect(whole), margin, whole.size());
    if (result.window.empty())
        return result;
    result.model = whole(result.window).clone();
    result.arms = cv::Mat::zeros(result.model.size(), CV_8U);
    result.armCores = result.arms.clone();
    for (std::size_t h = 0; h < std::min(hands.size(), poses.size()); ++h)
        if (isPosed(hands[h], poses[h]))
            addEnd(result, camera, hands[h], poses[h]);
    result.armCores &= result.arms;
    return result;
}

Seeds modelSeeds(const ModelInView& view) {
    Seeds seeds{view.window, {}};
    if (view.window.empty())
        return seeds;
    cv::Mat inside, outside;
    cv::distanceTransform(view.model, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cv::distanceTransform(255 - view.model, outside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cv::Mat& labels = seeds.labels;
    labels = cv::Mat(view.model.size(), CV_8U, cv::Scalar(seedValue(Seed::SureBackground)));
    labels.setTo(seedValue(Seed::ProbableBackground), outside <= view.bandPx);
    labels.setTo(seedValue(Seed::ProbableForeground), view.model);
    labels.setTo(seedValue(Seed::SureForeground), inside > view.bandPx);
    labels.setTo(seedValue(Seed::SureForeground), deepestLines(inside, view.bandPx));
    return seeds;
}

} // namespace core
