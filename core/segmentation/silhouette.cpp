// SPDX-License-Identifier: MIT
#include "core/segmentation/silhouette.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/segmentation/background_difference.h"
#include "core/segmentation/colour_mask.h"
#include "core/segmentation/landmark_seeds.h"
#include "core/segmentation/model_seeds.h"
#include "core/segmentation/seeded_cut.h"

namespace core {

namespace {

cv::Mat pasted(const cv::Mat& part, const cv::Rect& window, const cv::Size& size) {
    cv::Mat whole = cv::Mat::zeros(size, CV_8U);
    if (!window.empty())
        part.copyTo(whole(window));
    return whole;
}

cv::Mat sureForeground(const Seeds& seeds) {
    return seeds.labels == seedValue(Seed::SureForeground);
}

/// 255 beyond a line across a forearm, as wide as an arm can be; CV_8U of the window's size.
cv::Mat beyondLine(const ForearmLine& line, double palmPx, const cv::Rect& window) {
    const Eigen::Vector2d middle = (line.from + line.to) / 2, across = (line.to - line.from).normalized();
    constexpr double kWide = 1.5, kFar = 3; // palms
    cv::Mat mask = cv::Mat::zeros(window.size(), CV_8U);
    std::vector<cv::Point> corners;
    for (const auto& [side, along] : {std::pair(-1, 0), {1, 0}, {1, 1}, {-1, 1}}) {
        const Eigen::Vector2d px = middle + palmPx * (side * kWide / 2 * across + along * kFar * line.away);
        corners.emplace_back(cvRound(px.x()) - window.x, cvRound(px.y()) - window.y);
    }
    cv::fillConvexPoly(mask, corners, cv::Scalar(255));
    return mask;
}

/// Ends every forearm at a straight line; the other hand is not cut where it lies beyond it.
void cutForearms(cv::Mat& mask, const cv::Rect& window, const cv::Size& picture, const std::vector<HandInView>& hands,
                 double palms, std::vector<ForearmLine>& cuts) {
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const auto line = hands[h].isKnown() ? forearmLine(hands[h], palms) : std::nullopt;
        if (!line)
            continue;
        cuts.push_back(*line);
        std::vector<HandInView> others = hands;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(h));
        for (HandInView& other : others)
            other.forearmEnd.reset();
        cv::Mat beyond = beyondLine(*line, hands[h].palmPx, window);
        const Seeds spared = landmarkSeeds(picture, others);
        if (const cv::Rect both = spared.window & window; !both.empty()) {
            const cv::Mat labels = spared.labels(both - spared.window.tl());
            beyond(both - window.tl()).setTo(0, labels != seedValue(Seed::SureBackground));
        }
        mask.setTo(0, beyond);
    }
}

std::optional<Silhouette> byLandmarks(const cv::Mat& picture, const Camera& camera, const HandEvidence& evidence,
                                      const SilhouetteOptions& options) {
    std::vector<HandInView> hands;
    for (const LandmarkPoints& points : evidence.landmarks)
        hands.push_back(handInView(camera, points));
    if (hands.empty())
        return std::nullopt;
    const Seeds seeds = landmarkSeeds(picture.size(), hands);
    if (seeds.window.empty())
        return Silhouette{cv::Mat::zeros(picture.size(), CV_8U), {}};
    Silhouette result;
    cv::Mat mask = seededCut(picture, seeds);
    cutForearms(mask, seeds.window, picture.size(), hands, options.forearmPalms, result.cuts);
    result.mask = pasted(cleaned(mask, options.cleaning), seeds.window, picture.size());
    return result;
}

std::optional<Silhouette> byModel(const cv::Mat& picture, const Camera& camera, const std::vector<HandModel>& hands,
                                  const HandEvidence& evidence, const SilhouetteOptions& options) {
    const bool isPosed =
        std::any_of(evidence.poses.begin(), evidence.poses.end(), [](const Pose& pose) { return pose.size() > 0; });
    if (!isPosed)
        return std::nullopt;
    ModelSeedOptions seedOptions;
    seedOptions.bandMm = options.bandMm;
    const ModelSeeds model = modelSeeds(camera, hands, evidence.poses, seedOptions);
    if (model.seeds.window.empty())
        return Silhouette{cv::Mat::zeros(picture.size(), CV_8U), {}};
    cv::Mat mask = seededCut(picture, model.seeds);
    mask.setTo(0, model.arms);
    return Silhouette{
        pasted(cleaned(mask, options.cleaning, sureForeground(model.seeds)), model.seeds.window, picture.size()),
        model.cuts};
}

} // namespace

std::optional<Silhouette> findSilhouette(const cv::Mat& picture, const Camera& camera,
                                         const std::vector<HandModel>& hands, const HandEvidence& evidence,
                                         const cv::Mat& background, const SilhouetteOptions& options) {
    switch (options.method) {
    case SegmentationMethod::Landmarks:
        return byLandmarks(picture, camera, evidence, options);
    case SegmentationMethod::Model:
        return byModel(picture, camera, hands, evidence, options);
    case SegmentationMethod::Background:
        if (background.size() != picture.size())
            return std::nullopt;
        return Silhouette{cleaned(backgroundMask(picture, background), options.cleaning), {}};
    case SegmentationMethod::Chroma:
        return Silhouette{cleaned(chromaMask(picture, options.backdrop), options.cleaning), {}};
    case SegmentationMethod::Skin:
        return Silhouette{cleaned(skinMask(picture), options.cleaning), {}};
    }
    return std::nullopt;
}

double maskOverlap(const cv::Mat& a, const cv::Mat& b) {
    const int any = cv::countNonZero(a | b);
    return any == 0 ? 1 : static_cast<double>(cv::countNonZero(a & b)) / any;
}

} // namespace core
