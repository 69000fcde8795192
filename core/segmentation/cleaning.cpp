// SPDX-License-Identifier: MIT
#include "core/segmentation/cleaning.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace core {

namespace {

struct Parts {
    cv::Mat labels;         ///< CV_32S; 0 is the background
    std::vector<int> areas; ///< by label
};

Parts partsOf(const cv::Mat& mask, int connectivity) {
    Parts parts;
    cv::Mat statistics, centres;
    const int count = cv::connectedComponentsWithStats(mask, parts.labels, statistics, centres, connectivity);
    for (int i = 0; i < count; ++i)
        parts.areas.push_back(i == 0 ? 0 : statistics.at<int>(i, cv::CC_STAT_AREA));
    return parts;
}

/// 255 where the part is one of those.
cv::Mat maskOf(const Parts& parts, const std::vector<bool>& chosen) {
    cv::Mat mask(parts.labels.size(), CV_8U);
    for (int y = 0; y < mask.rows; ++y) {
        const int* labels = parts.labels.ptr<int>(y);
        auto* row = mask.ptr<uchar>(y);
        for (int x = 0; x < mask.cols; ++x)
            row[x] = chosen[static_cast<std::size_t>(labels[x])] ? 255 : 0;
    }
    return mask;
}

std::vector<bool> keptParts(const Parts& parts, const CleaningOptions& options, const cv::Mat& kept) {
    std::vector<bool> chosen(parts.areas.size(), false);
    std::vector<std::size_t> order(parts.areas.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{1});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return parts.areas[a] > parts.areas[b]; });
    const double all = std::accumulate(parts.areas.begin(), parts.areas.end(), 0.0);
    for (std::size_t i = 0; i < order.size() && i < static_cast<std::size_t>(options.mostParts); ++i)
        chosen[order[i]] = parts.areas[order[i]] >= options.leastPart * all;
    for (int y = 0; y < kept.rows; ++y)
        for (int x = 0; x < kept.cols; ++x)
            if (kept.at<uchar>(y, x) != 0)
                chosen[static_cast<std::size_t>(parts.labels.at<int>(y, x))] = true;
    chosen[0] = false;
    return chosen;
}

/// Fills the dark parts that are smaller than `areaPx` and do not touch the border: those are not holes.
void fillHoles(cv::Mat& mask, double areaPx) {
    const Parts dark = partsOf(255 - mask, 4);
    std::vector<bool> chosen(dark.areas.size());
    for (std::size_t i = 1; i < dark.areas.size(); ++i)
        chosen[i] = dark.areas[i] < areaPx;
    const auto spare = [&](int y, int x) { chosen[static_cast<std::size_t>(dark.labels.at<int>(y, x))] = false; };
    for (int x = 0; x < mask.cols; ++x) {
        spare(0, x);
        spare(mask.rows - 1, x);
    }
    for (int y = 0; y < mask.rows; ++y) {
        spare(y, 0);
        spare(y, mask.cols - 1);
    }
    mask |= maskOf(dark, chosen);
}

} // namespace

cv::Mat cleaned(const cv::Mat& mask, const CleaningOptions& options, const cv::Mat& kept) {
    if (mask.empty())
        return mask;
    const Parts parts = partsOf(mask, 8);
    cv::Mat result = maskOf(parts, keptParts(parts, options, kept));
    fillHoles(result, options.smallestHole * cv::countNonZero(result));
    return result;
}

void dropSmallParts(cv::Mat& mask, int areaPx) {
    for (const bool lit : {true, false}) {
        const Parts parts = partsOf(lit ? mask : cv::Mat(255 - mask), lit ? 8 : 4);
        std::vector<bool> isSmall(parts.areas.size());
        for (std::size_t i = 1; i < parts.areas.size(); ++i)
            isSmall[i] = parts.areas[i] < areaPx;
        mask.setTo(lit ? 0 : 255, maskOf(parts, isSmall));
    }
}

void keepReached(cv::Mat& mask, const cv::Mat& reached, double leastPx) {
    cv::Mat parts;
    std::vector<int> shared(static_cast<std::size_t>(cv::connectedComponents(mask, parts, 8, CV_32S)), 0);
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            shared[static_cast<std::size_t>(parts.at<int>(y, x))] += reached.at<uchar>(y, x) != 0 ? 1 : 0;
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            if (shared[static_cast<std::size_t>(parts.at<int>(y, x))] < leastPx)
                mask.at<uchar>(y, x) = 0;
}

} // namespace core
