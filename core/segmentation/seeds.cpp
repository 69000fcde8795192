// SPDX-License-Identifier: MIT
#include "core/segmentation/seeds.h"

#include <opencv2/imgproc.hpp>

namespace core {

cv::Mat foregroundOf(const cv::Mat& labels) {
    cv::Mat odd;
    cv::bitwise_and(labels, cv::Scalar(1), odd);
    return odd * 255;
}

cv::Rect grownWindow(const cv::Rect& rect, int marginPx, const cv::Size& picture) {
    if (rect.empty())
        return {};
    const cv::Rect wide(rect.x - marginPx, rect.y - marginPx, rect.width + 2 * marginPx, rect.height + 2 * marginPx);
    return wide & cv::Rect({}, picture);
}

cv::Mat grown(const cv::Mat& mask, double radiusPx) {
    const bool shrinks = radiusPx < 0;
    cv::Mat distance;
    cv::distanceTransform(shrinks ? mask : cv::Mat(255 - mask), distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return shrinks ? cv::Mat(distance > -radiusPx) : cv::Mat(distance <= radiusPx);
}

cv::Mat signedDistance(const cv::Mat& mask, int exactness) {
    cv::Mat inside, outside;
    cv::distanceTransform(mask, inside, cv::DIST_L2, exactness);
    cv::distanceTransform(255 - mask, outside, cv::DIST_L2, exactness);
    return inside - outside;
}

} // namespace core
