// SPDX-License-Identifier: MIT
#include "core/segmentation/odds_cut.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/segmentation/cleaning.h"

namespace core {

namespace {

constexpr int kBins = 16;          ///< per colour channel
constexpr float kMostEvidence = 3; ///< log odds of one pixel's colour
constexpr float kModelPull = 1.5f; ///< log odds at the band's ends, of the distance from the model's outline
constexpr double kSmoothPx = 1.0;
constexpr double kLeastPart = 0.02; ///< specks smaller than this share of the hands are left out

/// Colours of hand and surroundings, as log odds per colour bin.
class ColourOdds {
public:
    explicit ColourOdds(const cv::Mat& bgr)
        : m_bins(bgr.size(), CV_16U) {
        for (int y = 0; y < bgr.rows; ++y) {
            const auto* from = bgr.ptr<cv::Vec3b>(y);
            auto* to = m_bins.ptr<std::uint16_t>(y);
            for (int x = 0; x < bgr.cols; ++x)
                to[x] = static_cast<std::uint16_t>((from[x][0] / kBinWidth * kBins + from[x][1] / kBinWidth) * kBins +
                                                   from[x][2] / kBinWidth);
        }
    }
    /// CV_8U masks of what is surely hand, and surely not.
    void learn(const cv::Mat& hand, const cv::Mat& other) {
        std::vector<float> in = histogram(hand), out = histogram(other);
        m_odds.resize(in.size());
        for (std::size_t i = 0; i < in.size(); ++i)
            m_odds[i] = std::clamp(std::log((in[i] + kUnseen) / (out[i] + kUnseen)), -kMostEvidence, kMostEvidence);
    }
    cv::Mat evidence() const {
        cv::Mat result(m_bins.size(), CV_32F);
        for (int y = 0; y < m_bins.rows; ++y) {
            const auto* bins = m_bins.ptr<std::uint16_t>(y);
            auto* to = result.ptr<float>(y);
            for (int x = 0; x < m_bins.cols; ++x)
                to[x] = m_odds[bins[x]];
        }
        return result;
    }

private:
    static constexpr int kBinWidth = 256 / kBins;
    static constexpr float kUnseen = 2e-5f; ///< share of pixels that an unseen colour is taken to have

    /// Shares per bin, spread to the neighbouring ones.
    std::vector<float> histogram(const cv::Mat& mask) const {
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
    static std::vector<float> spread(const std::vector<float>& counts, int stride) {
        std::vector<float> result(counts.size());
        for (int i = 0; i < static_cast<int>(counts.size()); ++i) {
            const int at = i / stride % kBins;
            const float below = at > 0 ? counts[static_cast<std::size_t>(i - stride)] : 0;
            const float above = at + 1 < kBins ? counts[static_cast<std::size_t>(i + stride)] : 0;
            result[static_cast<std::size_t>(i)] = 0.5f * counts[static_cast<std::size_t>(i)] + 0.25f * (below + above);
        }
        return result;
    }

    cv::Mat m_bins;
    std::vector<float> m_odds;
};

/// Distance from the model's outline, px: positive inside.
cv::Mat signedDistance(const cv::Mat& model) {
    cv::Mat inside, outside;
    cv::distanceTransform(model, inside, cv::DIST_L2, 3);
    cv::distanceTransform(255 - model, outside, cv::DIST_L2, 3);
    return inside - outside;
}

} // namespace

cv::Mat oddsCut(const cv::Mat& picture, const ModelInView& view, int rounds) {
    const double bandPx = view.bandPx;
    const cv::Mat distance = signedDistance(view.model);
    const cv::Mat reachable = (distance > -bandPx) | view.arms;
    cv::Mat hand = distance > std::min(0.35 * bandPx, 6.0);
    cv::Mat other = (distance < -bandPx) & ~view.arms;
    ColourOdds odds(picture(view.window));
    const cv::Mat pull = cv::min(cv::max(distance * (kModelPull / bandPx), -kModelPull), kModelPull);
    cv::Mat mask;
    for (int round = 0; round < rounds; ++round) {
        odds.learn(hand, other);
        cv::Mat score = odds.evidence();
        cv::GaussianBlur(score, score, {0, 0}, kSmoothPx);
        mask = (score + pull > 0) & reachable;
        if (round + 1 == rounds)
            break;
        cv::erode(mask, hand, cv::Mat());
        cv::dilate(mask, other, cv::Mat());
        other = ~other;
    }
    keepReached(mask, view.model, kLeastPart * cv::countNonZero(view.model));
    return mask;
}

} // namespace core
