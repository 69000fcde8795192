// SPDX-License-Identifier: MIT
#include "core/io/footage/grey_levels.h"

#include <algorithm>
#include <cstdint>

#include <opencv2/core.hpp>

namespace core {

namespace {

constexpr int kLevels = 65536;
constexpr double kLeftOut = 0.001;
constexpr int kLeastRange = 255;

/// The first level, counted from one end, beyond which more than `left` pixels lie.
int levelAt(const std::vector<std::int64_t>& histogram, double left, bool fromDark) {
    std::int64_t passed = 0;
    for (int i = 0; i < kLevels; ++i) {
        const int level = fromDark ? i : kLevels - 1 - i;
        passed += histogram[static_cast<std::size_t>(level)];
        if (static_cast<double>(passed) > left)
            return level;
    }
    return fromDark ? kLevels - 1 : 0;
}

} // namespace

cv::Mat toEightBits(const cv::Mat& picture, const GreyLevels& levels) {
    if (picture.depth() != CV_16U)
        return picture;
    const double scale = 255.0 / std::max(levels.white - levels.black, 1);
    cv::Mat result;
    picture.convertTo(result, CV_8U, scale, -levels.black * scale);
    return result;
}

GreyLevels levelsByDepth(const cv::Mat& picture) {
    double most = 0;
    cv::minMaxLoc(picture.reshape(1), nullptr, &most);
    int bits = 8;
    while (bits < 16 && most >= (1 << bits))
        ++bits;
    return {0, (1 << bits) - 1};
}

std::optional<GreyLevels> measureLevels(const std::vector<cv::Mat>& pictures) {
    std::vector<std::int64_t> histogram(kLevels);
    double all = 0;
    for (const cv::Mat& picture : pictures) {
        if (picture.depth() != CV_16U)
            continue;
        all += static_cast<double>(picture.total()) * picture.channels();
        for (int y = 0; y < picture.rows; ++y) {
            const auto* row = picture.ptr<std::uint16_t>(y);
            for (int x = 0; x < picture.cols * picture.channels(); ++x)
                ++histogram[row[x]];
        }
    }
    if (all == 0)
        return std::nullopt;
    GreyLevels levels{levelAt(histogram, kLeftOut * all, true), levelAt(histogram, kLeftOut * all, false)};
    if (levels.white - levels.black < kLeastRange) { // nearly one level: no more contrast than 8 bits would show
        levels.black = std::clamp((levels.white + levels.black - kLeastRange) / 2, 0, kLevels - 1 - kLeastRange);
        levels.white = levels.black + kLeastRange;
    }
    return levels;
}

} // namespace core
