// SPDX-License-Identifier: MIT
#include "core/segmentation/sharp_edge.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace core {

namespace {

constexpr double kNearby = 3;      ///< side of the squares that colours are taken from, half, in reaches
constexpr float kLeastSamples = 6; ///< of each colour
constexpr float kContrast = 12;    ///< grey levels from which on two colours are told apart well
constexpr double kSmoothPx = 0.8;  ///< of the decision: a pixel's noise is not an edge

/// Sums of a mask's pixels and of their colours over squares.
struct ColourSums {
    cv::Mat count;  ///< CV_32F
    cv::Mat colour; ///< CV_32FC3
};

ColourSums sumsOf(const cv::Mat& picture, const cv::Mat& mask, int halfPx) {
    const cv::Size square(2 * halfPx + 1, 2 * halfPx + 1);
    cv::Mat masked = cv::Mat::zeros(picture.size(), CV_8UC3), ones;
    picture.copyTo(masked, mask);
    cv::bitwise_and(mask, cv::Scalar(1), ones);
    ColourSums sums;
    cv::boxFilter(masked, sums.colour, CV_32F, square, {-1, -1}, false, cv::BORDER_CONSTANT);
    cv::boxFilter(ones, sums.count, CV_32F, square, {-1, -1}, false, cv::BORDER_CONSTANT);
    return sums;
}

/// -0.5 .. 0.5: which of two colours a pixel has, and how sure that is.
float decision(const cv::Vec3b& pixel, const cv::Vec3f& in, const cv::Vec3f& out) {
    const cv::Vec3f between = in - out;
    const float contrast2 = between.dot(between);
    if (contrast2 < 1)
        return 0;
    const cv::Vec3f from = cv::Vec3f(pixel[0], pixel[1], pixel[2]) - out;
    const float share = std::clamp(from.dot(between) / contrast2 - 0.5F, -0.5F, 0.5F);
    return share * std::min(1.0F, contrast2 / (kContrast * kContrast));
}

} // namespace

cv::Mat sharpEdge(const cv::Mat& picture, const cv::Mat& mask, double reachPx) {
    cv::Mat inside, outside;
    cv::distanceTransform(mask, inside, cv::DIST_L2, 3);
    cv::distanceTransform(255 - mask, outside, cv::DIST_L2, 3);
    const auto reach = static_cast<float>(reachPx);
    const int half = std::max(2, static_cast<int>(std::ceil(kNearby * reachPx)));
    const ColourSums in = sumsOf(picture, inside > reach, half), out = sumsOf(picture, outside > reach, half);
    cv::Mat score(mask.size(), CV_32F);
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            const bool isIn = mask.at<uchar>(y, x) != 0;
            const float depth = isIn ? inside.at<float>(y, x) : outside.at<float>(y, x);
            float value = isIn ? 0.5F : -0.5F;
            const float a = in.count.at<float>(y, x), b = out.count.at<float>(y, x);
            if (depth <= reach && a >= kLeastSamples && b >= kLeastSamples) {
                // Decides where the colours do not; pixels at an edge are half a pixel from it.
                const float prior = 0.1F * (isIn ? depth - 0.5F : 0.5F - depth) / reach;
                value = prior + decision(picture.at<cv::Vec3b>(y, x), in.colour.at<cv::Vec3f>(y, x) / a,
                                         out.colour.at<cv::Vec3f>(y, x) / b);
            }
            score.at<float>(y, x) = value;
        }
    }
    cv::GaussianBlur(score, score, {}, kSmoothPx);
    return score > 0;
}

} // namespace core
