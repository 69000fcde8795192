// SPDX-License-Identifier: MIT
#include "core/segmentation/silhouette.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/contour/side_by_side.h"
#include "core/segmentation/background_difference.h"
#include "core/segmentation/colour_mask.h"
#include "core/segmentation/landmark_seeds.h"
#include "core/segmentation/model_seeds.h"
#include "core/segmentation/odds_cut.h"
#include "core/segmentation/seeded_cut.h"

namespace core {

namespace {

constexpr double kSeededArmPalms = 3; ///< what seeds make of an arm beyond its cut is shorter
constexpr double kWholeArmPalms = 12; ///< an arm up to the shoulder is shorter

cv::Mat pasted(const cv::Mat& part, const cv::Rect& window, const cv::Size& size) {
    cv::Mat whole = cv::Mat::zeros(size, CV_8U);
    if (!window.empty())
        part.copyTo(whole(window));
    return whole;
}

cv::Mat sureForeground(const Seeds& seeds) {
    return seeds.labels == seedValue(Seed::SureForeground);
}

/// 255 beyond a line across a forearm, as wide as an arm can be and that many palms far; CV_8U of the window's size.
cv::Mat beyondLine(const ForearmLine& line, double palmPx, double farPalms, const cv::Rect& window) {
    const Eigen::Vector2d middle = (line.from + line.to) / 2, across = (line.to - line.from).normalized();
    constexpr double kWide = 1.5; // palms
    cv::Mat mask = cv::Mat::zeros(window.size(), CV_8U);
    std::vector<cv::Point> corners;
    for (const auto& [side, along] : {std::pair(-1, 0), {1, 0}, {1, 1}, {-1, 1}}) {
        const Eigen::Vector2d px = middle + palmPx * (side * kWide / 2 * across + along * farPalms * line.away);
        corners.emplace_back(cvRound(px.x()) - window.x, cvRound(px.y()) - window.y);
    }
    cv::fillConvexPoly(mask, corners, cv::Scalar(255));
    return mask;
}

/// Ends every forearm at a straight line, `palms` from the wrist; the other hand is not cut where it lies beyond it.
void cutForearms(cv::Mat& mask, const cv::Rect& window, const cv::Size& picture, const std::vector<HandInView>& hands,
                 double palms, double farPalms, std::vector<ForearmLine>& cuts) {
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const auto line = hands[h].isKnown() ? forearmLine(hands[h], palms) : std::nullopt;
        if (!line)
            continue;
        cuts.push_back(*line);
        std::vector<HandInView> others = hands;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(h));
        for (HandInView& other : others)
            other.forearmEnd.reset();
        cv::Mat beyond = beyondLine(*line, hands[h].palmPx, farPalms, window);
        const Seeds spared = landmarkSeeds(picture, others);
        if (const cv::Rect both = spared.window & window; !both.empty()) {
            const cv::Mat labels = spared.labels(both - spared.window.tl());
            beyond(both - window.tl()).setTo(0, labels != seedValue(Seed::SureBackground));
        }
        mask.setTo(0, beyond);
    }
}

std::vector<HandInView> handsInView(const Camera& camera, const HandEvidence& evidence) {
    std::vector<HandInView> hands;
    for (const LandmarkPoints& points : evidence.landmarks)
        hands.push_back(handInView(camera, points));
    return hands;
}

std::optional<Silhouette> byLandmarks(const cv::Mat& picture, const Camera& camera, const HandEvidence& evidence,
                                      const SilhouetteOptions& options) {
    const std::vector<HandInView> hands = handsInView(camera, evidence);
    if (hands.empty())
        return std::nullopt;
    const Seeds seeds = landmarkSeeds(picture.size(), hands);
    if (seeds.window.empty())
        return Silhouette{cv::Mat::zeros(picture.size(), CV_8U), {}};
    Silhouette result;
    cv::Mat mask = seededCut(picture, seeds);
    cutForearms(mask, seeds.window, picture.size(), hands, options.forearmPalms, kSeededArmPalms, result.cuts);
    result.mask = pasted(cleaned(mask, options.cleaning), seeds.window, picture.size());
    return result;
}

std::optional<Silhouette> byModel(const cv::Mat& picture, const Camera& camera, const std::vector<HandModel>& hands,
                                  const HandEvidence& evidence, const SilhouetteOptions& options) {
    const bool isPosed =
        std::any_of(evidence.poses.begin(), evidence.poses.end(), [](const Pose& pose) { return pose.size() > 0; });
    if (!isPosed)
        return std::nullopt;
    ModelViewOptions viewOptions;
    viewOptions.bandMm = options.bandMm;
    const ModelInView view = modelInView(camera, hands, evidence.poses, viewOptions);
    if (view.window.empty())
        return Silhouette{cv::Mat::zeros(picture.size(), CV_8U), {}};
    const Seeds seeds = modelSeeds(view);
    cv::Mat mask = seededCut(picture, seeds);
    mask.setTo(0, view.arms);
    return Silhouette{pasted(cleaned(mask, options.cleaning, sureForeground(seeds)), view.window, picture.size()),
                      view.cuts};
}

bool isAnyKnown(const std::vector<HandInView>& hands) {
    return std::any_of(
        hands.begin(), hands.end(), [](const HandInView& hand) { return hand.isKnown(); });
}

/// Skin near the hands, where they are known: a room in skin's colours is not learnt from.
cv::Mat skinOfHands(const cv::Mat& picture, const Camera& camera, const HandEvidence& evidence) {
    const std::vector<HandInView> hands = handsInView(camera, evidence);
    if (!isAnyKnown(hands))
        return skinMask(picture);
    const cv::Rect window = landmarkSeeds(picture.size(), hands).window;
    return pasted(window.empty() ? cv::Mat() : skinMask(picture(window)), window, picture.size());
}

/// What a method found that knows nothing of hands: where they are known, forearms end, and what is none of theirs
/// goes.
Silhouette withoutArms(cv::Mat mask, const Camera& camera, const HandEvidence& evidence,
                       const SilhouetteOptions& options) {
    Silhouette result;
    const std::vector<HandInView> hands = handsInView(camera, evidence);
    if (isAnyKnown(hands)) {
        cutForearms(mask, {{0, 0}, mask.size()}, mask.size(), hands, options.forearmPalms, kWholeArmPalms, result.cuts);
        const Seeds seeds = landmarkSeeds(mask.size(), hands);
        keepReached(mask, pasted(sureForeground(seeds), seeds.window, mask.size()));
    }
    result.mask = cleaned(mask, options.cleaning);
    return result;
}

/// Whether arms are seen: surroundings look like one in some view, but not in most.
bool showsArms(const std::vector<ArmSigns>& views) {
    constexpr double kOwnShare = 0.5;
    int pixels = 0, own = 0;
    for (const ArmSigns& view : views) {
        pixels += view.pixels;
        own += view.own;
    }
    return own > kOwnShare * pixels;
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
        return withoutArms(backgroundMask(picture, background), camera, evidence, options);
    case SegmentationMethod::Chroma:
        return withoutArms(chromaMask(picture, options.backdrop), camera, evidence, options);
    case SegmentationMethod::Skin:
        return withoutArms(skinOfHands(picture, camera, evidence), camera, evidence, options);
    }
    return std::nullopt;
}

std::vector<cv::Mat> silhouettesByModel(const std::vector<Camera>& cameras, const std::vector<cv::Mat>& pictures,
                                        const std::vector<HandModel>& hands, const HandPoses& poses, double bandMm) {
    const std::size_t count = cameras.size();
    std::vector<ModelInView> views(count);
    std::vector<std::optional<OddsCut>> cuts(count);
    std::vector<ArmSigns> arms(count);
    forEachSideBySide(count, [&](std::size_t c) {
        if (pictures[c].empty())
            return;
        views[c] = modelInView(cameras[c], hands, poses, {bandMm, 2 * bandMm});
        if (views[c].window.empty())
            return;
        cuts[c].emplace(pictures[c], views[c]);
        arms[c] = cuts[c]->armSigns();
    });
    const bool armsAreSeen = showsArms(arms);
    std::vector<cv::Mat> masks(count);
    forEachSideBySide(count, [&](std::size_t c) {
        if (cuts[c])
            masks[c] = pasted(cuts[c]->mask(armsAreSeen), views[c].window, pictures[c].size());
    });
    return masks;
}

double maskOverlap(const cv::Mat& a, const cv::Mat& b) {
    const int any = cv::countNonZero(a | b);
    return any == 0 ? 1 : static_cast<double>(cv::countNonZero(a & b)) / any;
}

} // namespace core
