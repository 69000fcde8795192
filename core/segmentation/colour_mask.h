// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <opencv2/core/mat.hpp>

namespace core {

/// What has another colour than the backdrop (CV_8UC3 BGR in, CV_8U 0 and 255 out, same size), its edge made sharp.
/// `backdrop`: BGR; without one it is the most frequent colour at the picture's border. Distances are of lightness,
/// and, four times as much, of hue and saturation (CIE Lab): the light on a backdrop is never even. A picture without
/// anything before the backdrop gives an empty mask.
cv::Mat chromaMask(const cv::Mat& picture, const std::optional<cv::Scalar>& backdrop = std::nullopt);

/// The colour that most of a picture's border has, BGR.
cv::Scalar borderColour(const cv::Mat& picture);

/// What has the colour of skin, whatever its tone: between red and yellow in hue, within limits of Cr and Cb (Chai and
/// Ngan 1999) that are then narrowed to the picture's own skin. Wood, cardboard and faces look alike to it.
cv::Mat skinMask(const cv::Mat& picture);

} // namespace core
