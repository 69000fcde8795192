// SPDX-License-Identifier: MIT
#include "core/segmentation/odds_cut.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/segmentation/cleaning.h"

namespace core {

namespace {

constexpr int kBins = 16; ///< per colour channel
constexpr int kBinWidth = 256 / kBins;
constexpr float kUnseen = 2e-5f;   ///< share of pixels that an unseen colour is taken to have
constexpr float kMostEvidence = 3; ///< log odds of one pixel's colour
constexpr float kModelPull = 1.5f; ///< log odds at the band's ends, of the distance from the model's outline
constexpr double kSmoothPx = 1.0;
constexpr float kOwnColour = 1;     ///< log odds from which on a colour is more likely an arm's
constexpr double kBesideBands = 5;  ///< how far beside an arm's axis surroundings are compared with it
constexpr double kLeastPart = 0.02; ///< specks smaller than this share of the hands are left out

cv::Mat colourBins(const cv::Mat& bgr) {
    cv::Mat bins(bgr.size(), CV_16U);
    for (int y = 0; y < bgr.rows; ++y) {
        const auto* from = bgr.ptr<cv::Vec3b>(y);
        auto* to = bins.ptr<std::uint16_t>(y);
        for (int x = 0; x < bgr.cols; ++x)
            to[x] = static_cast<std::uint16_t>((from[x][0] / kBinWidth * kBins + from[x][1] / kBinWidth) * kBins +
                                               from[x][2] / kBinWidth);
    }
    return bins;
}

std::vector<float> spread(const std::vector<float>& counts, int stride) {
    std::vector<float> result(counts.size());
    for (int i = 0; i < static_cast<int>(counts.size()); ++i) {
        const int at = i / stride % kBins;
        const float below = at > 0 ? counts[static_cast<std::size_t>(i - stride)] : 0;
        const float above = at + 1 < kBins ? counts[static_cast<std::size_t>(i + stride)] : 0;
        result[static_cast<std::size_t>(i)] = 0.5f * counts[static_cast<std::size_t>(i)] + 0.25f * (below + above);
    }
    return result;
}

/// 255 within a distance of what is lit in a mask.
cv::Mat reachOf(const cv::Mat& mask, double px) {
    if (cv::countNonZero(mask) == 0)
        return mask;
    cv::Mat away;
    cv::distanceTransform(255 - mask, away, cv::DIST_L2, 3);
    return away < px;
}

} // namespace

OddsCut::OddsCut(const cv::Mat& picture, const ModelInView& view)
    : m_view(view)
    , m_bins(colourBins(picture(view.window)))
    , m_distance(signedDistance(view.model, cv::DIST_MASK_3))
    , m_pull(cv::min(cv::max(m_distance * (kModelPull / view.bandPx), -kModelPull), kModelPull))
    , m_first{m_distance > std::min(0.35 * view.bandPx, 6.0), view.armCores, (m_distance < -view.bandPx) & ~view.arms} {
}

/// Shares per bin, spread to the neighbouring ones.
std::vector<float> OddsCut::histogram(const cv::Mat& mask) const {
    std::vector<float> counts(kBins * kBins * kBins, 0.f);
    double total = 0;
    for (int y = 0; y < mask.rows; ++y) {
        const auto* in = mask.ptr<std::uint8_t>(y);
        const auto* bins = m_bins.ptr<std::uint16_t>(y);
        for (int x = 0; x < mask.cols; ++x)
            if (in[x]) {
                ++counts[bins[x]];
                ++total;
            }
    }
    for (const int stride : {1, kBins, kBins * kBins})
        counts = spread(counts, stride);
    for (float& count : counts)
        count = static_cast<float>(count / std::max(1.0, total));
    return counts;
}

/// Log odds of every pixel by its colour, CV_32F.
cv::Mat OddsCut::evidence(const cv::Mat& in, const cv::Mat& out) const {
    const std::vector<float> inside = histogram(in), outside = histogram(out);
    std::vector<float> odds(inside.size());
    for (std::size_t i = 0; i < inside.size(); ++i)
        odds[i] = std::clamp(std::log((inside[i] + kUnseen) / (outside[i] + kUnseen)), -kMostEvidence, kMostEvidence);
    cv::Mat result(m_bins.size(), CV_32F);
    for (int y = 0; y < m_bins.rows; ++y) {
        const auto* bins = m_bins.ptr<std::uint16_t>(y);
        auto* to = result.ptr<float>(y);
        for (int x = 0; x < m_bins.cols; ++x)
            to[x] = odds[bins[x]];
    }
    cv::GaussianBlur(result, result, {0, 0}, kSmoothPx);
    return result;
}

cv::Mat OddsCut::handScore(const Samples& samples) const {
    return evidence(samples.hand, samples.other) + m_pull;
}

ArmSigns OddsCut::armSigns() const {
    const cv::Mat beside = m_first.other & reachOf(m_first.arm, kBesideBands * m_view.bandPx);
    const int pixels = cv::countNonZero(m_first.arm);
    if (pixels == 0 || 4 * cv::countNonZero(beside) < pixels)
        return {};
    return {pixels, cv::countNonZero((evidence(m_first.arm, beside) > kOwnColour) & m_first.arm)};
}

cv::Mat OddsCut::mask(bool showsArms, int rounds) const {
    const cv::Mat reachable = (m_distance > -m_view.bandPx) | m_view.arms;
    const cv::Mat nearArms = showsArms ? reachOf(m_view.arms, m_view.bandPx) : cv::Mat();
    Samples samples = m_first;
    cv::Mat mask;
    for (int round = 0; round < rounds; ++round) {
        cv::Mat score = handScore(samples);
        if (showsArms)
            cv::Mat(cv::max(score, evidence(samples.arm, samples.other))).copyTo(score, nearArms);
        mask = (score > 0) & reachable;
        if (round + 1 == rounds)
            break;
        cv::erode(mask, samples.hand, cv::Mat());
        cv::dilate(mask, samples.other, cv::Mat());
        samples.other = ~samples.other;
        if (showsArms) {
            samples.arm = samples.hand & m_view.arms;
            samples.hand &= ~m_view.arms;
        }
    }
    keepReached(mask, m_view.model, kLeastPart * cv::countNonZero(m_view.model));
    return mask;
}

} // namespace core
