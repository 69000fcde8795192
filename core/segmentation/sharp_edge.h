// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core/mat.hpp>

namespace core {

/// Moves the edge of a mask to where the picture's colour is half way between those nearby inside and nearby outside:
/// where an edge that is blurred by lens and motion has its middle. `picture` CV_8UC3 and `mask` CV_8U (0 and 255) have
/// the same size. Pixels farther than `reachPx` from the mask's edge keep what they are, and so do those where the two
/// colours cannot be told apart or one of them has no sample nearby.
cv::Mat sharpEdge(const cv::Mat& picture, const cv::Mat& mask, double reachPx);

} // namespace core
