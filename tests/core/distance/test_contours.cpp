// SPDX-License-Identifier: MIT
#include "tests/core/distance/test_contours.h"

#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "core/numeric/random.h"

namespace core::testing {

namespace {

void drawHand(cv::Mat& mask, cv::Point2d palm, double directionRad, double unit) {
    const cv::Scalar inside(255);
    const auto along = [&](double angle, double length) {
        return cv::Point(static_cast<int>(palm.x + length * unit * std::cos(angle)),
                         static_cast<int>(palm.y + length * unit * std::sin(angle)));
    };
    cv::ellipse(mask, cv::Point(palm), cv::Size(static_cast<int>(unit), static_cast<int>(0.8 * unit)),
                directionRad * 180 / std::numbers::pi, 0, 360, inside, cv::FILLED);
    for (int finger = -2; finger <= 2; ++finger) {
        cv::line(mask, cv::Point(palm), along(directionRad + 0.35 * finger, 2.6), inside,
                 static_cast<int>(0.35 * unit));
    }
    cv::line(mask, cv::Point(palm), along(directionRad + std::numbers::pi, 9), inside, static_cast<int>(0.8 * unit));
}

} // namespace

cv::Mat crossingHandsMask(int width, int height) {
    cv::Mat mask(height, width, CV_8U, cv::Scalar(0));
    const double unit = 0.13 * std::min(width, height);
    drawHand(mask, {0.33 * width, 0.55 * height}, -0.35, unit);
    drawHand(mask, {0.67 * width, 0.5 * height}, std::numbers::pi + 0.3, unit);
    return mask;
}

OrientedContour gridContour(const cv::Mat& mask) {
    ContourOptions options;
    options.offsetPx = 0;
    return orientedContour(mask, options);
}

OrientedContour randomContour(int count, int width, int height, std::uint64_t seed) {
    RandomGenerator random(seed);
    OrientedContour contour;
    for (int i = 0; i < count; ++i) {
        contour.x.push_back(static_cast<float>(std::floor((1.4 * random.uniform() - 0.2) * width)));
        contour.y.push_back(static_cast<float>(std::floor((1.4 * random.uniform() - 0.2) * height)));
        contour.angleRad.push_back(static_cast<float>((2 * random.uniform() - 1) * std::numbers::pi));
    }
    return contour;
}

} // namespace core::testing
