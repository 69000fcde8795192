// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/io/footage/view_source.h"

namespace core {

/// A picture of 16 bits per channel as one of 8: black and what is darker to 0, white and what is brighter to 255,
/// linear in between. Pictures of 8 bits are returned as they are.
cv::Mat toEightBits(const cv::Mat& picture, const GreyLevels& levels);

/// 0 to the largest level of the fewest bits (8 to 16) that hold every level of the picture: 4095 for 12-bit cameras.
GreyLevels levelsByDepth(const cv::Mat& picture);

/// Black and white points that leave out the darkest and the brightest thousandth of all pixels of these pictures, at
/// least 255 levels apart; empty if none of them has more than 8 bits.
std::optional<GreyLevels> measureLevels(const std::vector<cv::Mat>& pictures);

} // namespace core
