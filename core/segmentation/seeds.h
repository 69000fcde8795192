// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core/mat.hpp>

namespace core {

/// What is known of a pixel before the picture is looked at.
enum class Seed : uchar { SureBackground = 0, SureForeground = 1, ProbableBackground = 2, ProbableForeground = 3 };
constexpr double seedValue(Seed seed) {
    return static_cast<double>(static_cast<uchar>(seed));
}

/// Seeds of a part of a picture; everything outside the window is sure background.
struct Seeds {
    cv::Rect window; ///< within the picture; empty if the hand is not in it
    cv::Mat labels;  ///< CV_8U of the window's size, values of Seed
};

/// 255 where the label is one of foreground, sure or probable; CV_8U of the same size.
cv::Mat foregroundOf(const cv::Mat& labels);

/// The rectangle grown by `marginPx` to all sides, within a picture of that size.
cv::Rect grownWindow(const cv::Rect& rect, int marginPx, const cv::Size& picture);

/// Grows (or shrinks, for negative radii) a mask by a disc of that radius, px: an exact distance, not a staircase. What
/// lies outside the mask's own rectangle does not shrink it.
cv::Mat grown(const cv::Mat& mask, double radiusPx);

/// Distance from the outline of a mask (CV_8U, 0 and 255), px, CV_32F: positive inside. `exactness`: a value of
/// cv::DistanceTransformMasks.
cv::Mat signedDistance(const cv::Mat& mask, int exactness);

} // namespace core
