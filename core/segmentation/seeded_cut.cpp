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

} // namespace

cv::Mat seededCut(const cv::Mat& picture, const Seeds& seeds, const SeededCutOptions& options) {
    if (seeds.window.empty())
        return {};
    const cv::Mat whole = picture(seeds.window);
    const double scale = std::min(1.0, std::sqrt(options.mostPixels / static_cast<double>(whole.total())));
    cv::Mat part = whole, labels = seeds.labels.clone();
    if (scale < 1) {
        const cv::Size size(std::max(1, cvRound(whole.cols * scale)), std::max(1, cvRound(whole.rows * scale)));
        cv::resize(whole, part, size, 0, 0, cv::INTER_AREA);
        labels = scaledLabels(seeds.labels, size);
    }
    if (!canLearn(labels))
        return foregroundOf(seeds.labels);
    cv::Mat background, foreground;
    cv::theRNG().state = kColourSeed;
    cv::grabCut(part, labels, {}, background, foreground, options.iterations, cv::GC_INIT_WITH_MASK);
    cv::Mat mask = foregroundOf(labels);
    if (scale < 1) {
        cv::resize(mask, mask, whole.size(), 0, 0, cv::INTER_LINEAR);
        mask = mask > 127;
    }
    keepSure(mask, seeds.labels);
    mask = sharpEdge(whole, mask, kEdgeReachPx / scale);
    keepSure(mask, seeds.labels);
    return mask;
}

} // namespace core
