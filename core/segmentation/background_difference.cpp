// SPDX-License-Identifier: MIT
#include "core/segmentation/background_difference.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

#include "core/segmentation/cleaning.h"

namespace core {

namespace {

constexpr double kSoftPx = 1.2;
constexpr int kSmallPx = 400;

/// A mask whose edge lies where the difference is half of what it is farther in: the picture's blur makes a lower
/// threshold's masks fatter by a pixel.
cv::Mat atHalfContrast(const cv::Mat& difference, const cv::Mat& mask) {
    constexpr int kEdgePx = 9, kNearPx = 11;
    cv::Mat inside, nearby;
    cv::erode(mask, inside, cv::getStructuringElement(cv::MORPH_ELLIPSE, {kEdgePx, kEdgePx}));
    cv::dilate(difference, nearby, cv::getStructuringElement(cv::MORPH_ELLIPSE, {kNearPx, kNearPx}));
    return inside | (mask & (difference > 0.5 * nearby));
}

cv::Mat softened(const cv::Mat& picture) {
    cv::Mat soft;
    cv::GaussianBlur(picture, soft, {}, kSoftPx);
    return soft;
}

/// Of the channel that differs most; CV_8U.
cv::Mat largestDifference(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    std::array<cv::Mat, 3> channels;
    cv::split(difference, channels);
    return cv::max(channels[0], cv::max(channels[1], channels[2]));
}

cv::Mat closedAndOpened(const cv::Mat& mask) {
    cv::Mat result;
    const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5});
    cv::morphologyEx(mask, result, cv::MORPH_CLOSE, disc);
    cv::morphologyEx(result, result, cv::MORPH_OPEN, disc);
    return result;
}

/// The level below which half of the pixels are.
int medianLevel(const cv::Mat& grey) {
    std::array<int, 256> counts{};
    for (int y = 0; y < grey.rows; ++y)
        for (int x = 0; x < grey.cols; ++x)
            ++counts[grey.at<uchar>(y, x)];
    int sum = 0, level = 0;
    while (level < 255 && (sum += counts[static_cast<std::size_t>(level)]) * 2 < static_cast<int>(grey.total()))
        ++level;
    return level;
}

/// The background as bright as the picture is.
cv::Mat matchedExposure(const cv::Mat& background, const cv::Mat& picture) {
    cv::Mat a, b, matched;
    cv::cvtColor(picture, a, cv::COLOR_BGR2GRAY);
    cv::cvtColor(background, b, cv::COLOR_BGR2GRAY);
    const double factor = std::clamp((medianLevel(a) + 1.0) / (medianLevel(b) + 1.0), 0.8, 1.25);
    background.convertTo(matched, -1, factor);
    return matched;
}

/// 255 where a pixel is the background in less light.
cv::Mat shadowsOf(const cv::Mat& picture, const cv::Mat& background, const BackgroundOptions& options) {
    cv::Mat shadows = cv::Mat::zeros(picture.size(), CV_8U);
    for (int y = 0; y < picture.rows; ++y) {
        const auto* seen = picture.ptr<cv::Vec3b>(y);
        const auto* room = background.ptr<cv::Vec3b>(y);
        for (int x = 0; x < picture.cols; ++x) {
            const cv::Vec3d now = seen[x], then = room[x];
            const double light = now[0] + now[1] + now[2], lightThen = then[0] + then[1] + then[2];
            if (light < options.darkestShadow * lightThen || light > lightThen || light < 1)
                continue;
            const cv::Vec3d shift = now / light - then / lightThen;
            if (std::max({std::abs(shift[0]), std::abs(shift[1]), std::abs(shift[2])}) < options.shadowColour)
                shadows.at<uchar>(y, x) = 255;
        }
    }
    return shadows;
}

} // namespace

cv::Mat differenceMask(const cv::Mat& picture, const cv::Mat& background) {
    constexpr double kThreshold = 12; // of pictures whose noise is 2 to 4 levels before the blur
    const cv::Mat difference = largestDifference(softened(picture), softened(background));
    cv::Mat mask = closedAndOpened(atHalfContrast(difference, difference > kThreshold));
    dropSmallParts(mask, kSmallPx);
    return mask;
}

cv::Mat backgroundMask(const cv::Mat& picture, const cv::Mat& background, const BackgroundOptions& options) {
    const cv::Mat seen = softened(picture), room = softened(matchedExposure(background, picture));
    cv::Mat difference = largestDifference(seen, room);
    const cv::Mat shadows = shadowsOf(seen, room, options);
    const cv::Mat differs = (difference > options.leastDifference) & ~shadows;
    cv::Mat mask = closedAndOpened(atHalfContrast(difference, differs));
    dropSmallParts(mask, kSmallPx);
    return mask;
}

cv::Mat medianPicture(const std::vector<cv::Mat>& pictures) {
    if (pictures.empty())
        return {};
    std::vector<cv::Mat> same;
    for (const cv::Mat& picture : pictures)
        if (picture.size() == pictures.front().size())
            same.push_back(picture);
    cv::Mat median(same.front().size(), CV_8UC3);
    std::vector<uchar> values(same.size());
    for (int y = 0; y < median.rows; ++y) {
        auto* row = median.ptr<uchar>(y);
        for (int i = 0; i < 3 * median.cols; ++i) {
            for (std::size_t k = 0; k < same.size(); ++k)
                values[k] = same[k].ptr<uchar>(y)[i];
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::nth_element(values.begin(), middle, values.end());
            row[i] = *middle;
        }
    }
    return median;
}

} // namespace core
