// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/imgproc.hpp>

namespace test {

/// A picture of one colour, with noise of that many grey levels, the same for a seed.
inline cv::Mat noisyColour(const cv::Size& size, const cv::Scalar& colour, double sigma, int seed) {
    cv::Mat picture(size, CV_16SC3, colour), noise(size, CV_16SC3);
    cv::RNG random(static_cast<std::uint64_t>(seed));
    random.fill(noise, cv::RNG::NORMAL, 0, sigma);
    picture += noise;
    picture.convertTo(picture, CV_8UC3);
    return picture;
}

/// A disc as a mask, by its definition.
inline cv::Mat discMask(const cv::Size& size, cv::Point2d centre, double radius) {
    cv::Mat mask = cv::Mat::zeros(size, CV_8U);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (std::hypot(x - centre.x, y - centre.y) <= radius)
                mask.at<uchar>(y, x) = 255;
    return mask;
}

/// `front` where the mask is lit, `back` elsewhere, the edge as soft as a lens makes it.
inline cv::Mat composed(const cv::Mat& front, const cv::Mat& back, const cv::Mat& mask, double blurPx) {
    cv::Mat picture = back.clone();
    front.copyTo(picture, mask);
    if (blurPx > 0)
        cv::GaussianBlur(picture, picture, {}, blurPx);
    return picture;
}

inline const cv::Scalar kSkin(110, 140, 200), kGrey(95, 95, 95), kGreen(70, 170, 60);

} // namespace test
