// SPDX-License-Identifier: MIT
#include "core/segmentation/colour_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/segmentation/cleaning.h"
#include "core/segmentation/sharp_edge.h"

namespace core {

namespace {

constexpr double kSoftPx = 1.5;
constexpr double kReachPx = 3;
constexpr int kBins = 16; ///< per channel, of the border's colours
constexpr float kLightness = 0.25F;
constexpr double kLeastChroma = 22;  ///< Lab units: below it are noise and uneven light of the backdrop
constexpr double kMostChroma = 40;   ///< above it there is no doubt
constexpr double kSkinShare = 0.002; ///< of the picture, below which skin has no colour of its own

/// How often colours occur, in bins.
class ColourCounts {
public:
    void add(const cv::Vec3b& pixel) {
        constexpr int kStep = 256 / kBins;
        Bin& bin =
            m_bins[static_cast<std::size_t>((pixel[0] / kStep * kBins + pixel[1] / kStep) * kBins + pixel[2] / kStep)];
        bin.sum += cv::Vec3d(pixel[0], pixel[1], pixel[2]);
        ++bin.count;
    }
    /// The mean of the fullest bin.
    cv::Scalar most() const {
        const Bin& fullest = *std::max_element(m_bins.begin(), m_bins.end(),
                                               [](const Bin& a, const Bin& b) { return a.count < b.count; });
        const cv::Vec3d mean = fullest.sum / std::max(1, fullest.count);
        return {mean[0], mean[1], mean[2]};
    }

private:
    struct Bin {
        cv::Vec3d sum{0, 0, 0};
        int count = 0;
    };
    std::vector<Bin> m_bins = std::vector<Bin>(static_cast<std::size_t>(kBins * kBins * kBins));
};

cv::Mat softLab(const cv::Mat& picture) {
    cv::Mat soft, lab;
    cv::GaussianBlur(picture, soft, {}, kSoftPx);
    cv::cvtColor(soft, lab, cv::COLOR_BGR2Lab);
    return lab;
}

/// The distance of every pixel from a colour, CV_8U, saturated.
cv::Mat distanceFrom(const cv::Mat& lab, const cv::Vec3b& colour) {
    cv::Mat distance(lab.size(), CV_8U);
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            const cv::Vec3b& pixel = lab.at<cv::Vec3b>(y, x);
            const float l = kLightness * static_cast<float>(pixel[0] - colour[0]);
            const auto a = static_cast<float>(pixel[1] - colour[1]), b = static_cast<float>(pixel[2] - colour[2]);
            distance.at<uchar>(y, x) = cv::saturate_cast<uchar>(std::sqrt(l * l + a * a + b * b));
        }
    }
    return distance;
}

cv::Mat tidied(const cv::Mat& picture, cv::Mat mask) {
    const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5});
    cv::morphologyEx(mask, mask, cv::MORPH_OPEN, disc);
    cv::morphologyEx(mask, mask, cv::MORPH_CLOSE, disc);
    return cleaned(sharpEdge(picture, mask, kReachPx));
}

/// Mean and spread of Cr and Cb in a mask, as the limits of what has the same colour.
cv::Mat sameChroma(const cv::Mat& ycrcb, const cv::Mat& mask) {
    constexpr double kDeviations = 2.5, kLeast = 3;
    cv::Scalar mean, deviation;
    cv::meanStdDev(ycrcb, mean, deviation, mask);
    cv::Scalar low = mean, high = mean;
    for (const int k : {1, 2}) {
        low[k] -= kDeviations * std::max(deviation[k], kLeast);
        high[k] += kDeviations * std::max(deviation[k], kLeast);
    }
    low[0] = 0;
    high[0] = 255;
    cv::Mat same;
    cv::inRange(ycrcb, low, high, same);
    return same;
}

} // namespace

cv::Scalar borderColour(const cv::Mat& picture) {
    ColourCounts counts;
    const int width = std::max(1, std::min(picture.rows, picture.cols) / 40);
    for (int y = 0; y < picture.rows; ++y) {
        const bool isBand = y < width || y >= picture.rows - width;
        const auto* row = picture.ptr<cv::Vec3b>(y);
        for (int x = 0; x < picture.cols; ++x)
            if (isBand || x < width || x >= picture.cols - width)
                counts.add(row[x]);
    }
    return counts.most();
}

cv::Mat chromaMask(const cv::Mat& picture, const std::optional<cv::Scalar>& backdrop) {
    const cv::Scalar colour = backdrop ? *backdrop : borderColour(picture);
    cv::Mat sample(1, 1, CV_8UC3, colour), sampleLab, binary;
    cv::cvtColor(sample, sampleLab, cv::COLOR_BGR2Lab);
    const cv::Mat distance = distanceFrom(softLab(picture), sampleLab.at<cv::Vec3b>(0, 0));
    // Otsu's threshold of a picture with nothing in it lies in the backdrop's noise.
    const double otsu = cv::threshold(distance, binary, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
    return tidied(picture, distance > std::clamp(otsu, kLeastChroma, kMostChroma));
}

cv::Mat skinMask(const cv::Mat& picture) {
    cv::Mat soft, ycrcb, mask;
    cv::GaussianBlur(picture, soft, {}, kSoftPx);
    cv::cvtColor(soft, ycrcb, cv::COLOR_BGR2YCrCb);
    cv::inRange(ycrcb, cv::Scalar(30, 133, 77), cv::Scalar(255, 180, 128), mask);
    if (cv::countNonZero(mask) > kSkinShare * static_cast<double>(mask.total())) {
        const cv::Mat core = cleaned(mask);
        if (cv::countNonZero(core) > 0)
            mask &= sameChroma(ycrcb, core);
    }
    return tidied(picture, mask);
}

} // namespace core
