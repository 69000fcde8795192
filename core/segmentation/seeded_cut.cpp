// SPDX-License-Identifier: MIT
#include "core/segmentation/seeded_cut.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/segmentation/sharp_edge.h"

namespace core {

namespace {

constexpr std::uint64_t kColourSeed = 0x5eed; ///< colours are clustered from random starts: always the same ones
constexpr int kLeastSamples = 24;             ///< of each side, to learn five colours from
constexpr double kEdgeReachPx = 2;            ///< how far the edge of a cut at full size may be off

bool canLearn(const cv::Mat& labels) {
    const int foreground = cv::countNonZero(foregroundOf(labels));
    return foreground >= kLeastSamples && static_cast<int>(labels.total()) - foreground >= kLeastSamples;
}

/// The sure pixels of the full size stay sure where the scale would lose a thin line of them.
cv::Mat scaledLabels(const cv::Mat& labels, const cv::Size& size) {
    cv::Mat scaled, sure;
    cv::resize(labels, scaled, size, 0, 0, cv::INTER_NEAREST);
    cv::resize(labels == seedValue(Seed::SureForeground), sure, size, 0, 0, cv::INTER_AREA);
    scaled.setTo(seedValue(Seed::SureForeground), sure > 127);
    return scaled;
}

void keepSure(cv::Mat& mask, const cv::Mat& labels) {
    mask.setTo(0, labels == seedValue(Seed::SureBackground));
    mask.setTo(255, labels == seedValue(Seed::SureForeground));
}

/// A window of a picture and its labels, scaled down to that many pixels.
struct Scaled {
    cv::Mat picture;
    cv::Mat labels;
    double scale = 1;
};

Scaled scaledTo(int mostPixels, const cv::Mat& picture, const cv::Mat& labels) {
    const double scale = std::min(1.0, std::sqrt(mostPixels / static_cast<double>(picture.total())));
    if (scale >= 1)
        return {picture, labels.clone(), 1};
    const cv::Size size(std::max(1, cvRound(picture.cols * scale)), std::max(1, cvRound(picture.rows * scale)));
    Scaled result{{}, scaledLabels(labels, size), scale};
    cv::resize(picture, result.picture, size, 0, 0, cv::INTER_AREA);
    return result;
}

} // namespace

cv::Mat seededCut(const cv::Mat& picture, const Seeds& seeds, const SeededCutOptions& options) {
    if (seeds.window.empty())
        return {};
    const cv::Mat whole = picture(seeds.window);
    Scaled cut = scaledTo(std::min(options.learnPixels, options.mostPixels), whole, seeds.labels);
    if (!canLearn(cut.labels))
        return foregroundOf(seeds.labels);
    cv::Mat background, foreground;
    cv::theRNG().state = kColourSeed;
    cv::grabCut(cut.picture, cut.labels, {}, background, foreground, options.iterations, cv::GC_INIT_WITH_MASK);
    if (cut.scale < 1 && options.mostPixels > options.learnPixels) {
        cut = scaledTo(options.mostPixels, whole, seeds.labels);
        cv::grabCut(cut.picture, cut.labels, {}, background, foreground, 1, cv::GC_EVAL_FREEZE_MODEL);
    }
    cv::Mat mask = foregroundOf(cut.labels);
    if (cut.scale < 1) {
        cv::resize(mask, mask, whole.size(), 0, 0, cv::INTER_LINEAR);
        mask = mask > 127;
    }
    keepSure(mask, seeds.labels);
    mask = sharpEdge(whole, mask, kEdgeReachPx / cut.scale);
    keepSure(mask, seeds.labels);
    return mask;
}

} // namespace core
