// SPDX-License-Identifier: MIT
#include "core/contour/oriented_contour.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/distance/circular_distance.h"
#include "core/error.h"
#include "tests/support/random_values.h"

namespace {

using core::ContourNormals;
using core::ContourOptions;
using core::OrientedContour;

/// A disc by the pixel-centre rule, drawn over what is there.
void drawDisc(cv::Mat& mask, double cx, double cy, double radius, int value = 255) {
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x)
            if (std::hypot(x - cx, y - cy) < radius)
                mask.at<unsigned char>(y, x) = static_cast<unsigned char>(value);
    }
}

cv::Mat background(int width, int height) {
    return cv::Mat(height, width, CV_8U, cv::Scalar(0));
}

struct CircleErrors {
    std::vector<double> normalDeg; ///< ascending
    double meanRadius = 0;
};

/// Of the points that lie nearest to the circle of that radius; inwards: the normals should point to its centre.
CircleErrors circleErrors(const OrientedContour& contour, double cx, double cy, double radius, bool inwards = false) {
    CircleErrors errors;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const double dx = static_cast<double>(contour.x[i]) - cx, dy = static_cast<double>(contour.y[i]) - cy;
        const double r = std::hypot(dx, dy);
        if (std::abs(r - radius) > 3)
            continue;
        const double outward = inwards ? std::atan2(-dy, -dx) : std::atan2(dy, dx);
        errors.normalDeg.push_back(180 / M_PI *
                                   core::signedCircularDistance(static_cast<double>(contour.angleRad[i]), outward));
        errors.meanRadius += r;
    }
    std::sort(errors.normalDeg.begin(), errors.normalDeg.end());
    errors.meanRadius /= static_cast<double>(errors.normalDeg.size());
    return errors;
}

double percentile(const std::vector<double>& ascending, double share) {
    return ascending.at(static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1)));
}

TEST(OrientedContour, OfADiscLiesOnItsCircleAndPointsOutward) {
    test::RandomValues random("disc");
    for (const double radius : {12.0, 20.0, 33.3, 60.0}) {
        double mean = 0;
        constexpr int kTrials = 10;
        for (int trial = 0; trial < kTrials; ++trial) {
            const double cx = random.between(70, 80), cy = random.between(70, 80);
            cv::Mat mask = background(160, 150);
            drawDisc(mask, cx, cy, radius);
            const CircleErrors errors = circleErrors(core::orientedContour(mask), cx, cy, radius);
            ASSERT_GT(errors.normalDeg.size(), 4 * radius);
            EXPECT_LT(percentile(errors.normalDeg, 0.95), 24) << radius;
            EXPECT_NEAR(errors.meanRadius, radius, 0.2) << radius;
            mean += errors.meanRadius / kTrials;
        }
        EXPECT_NEAR(mean, radius, 0.1) << "the half pixel is accounted for";
    }
}

TEST(OrientedContour, ChordNormalsAreSmoother) {
    cv::Mat mask = background(160, 150);
    drawDisc(mask, 80.3, 74.8, 55);
    ContourOptions options;
    options.normals = ContourNormals::Chord;
    const CircleErrors errors = circleErrors(core::orientedContour(mask, options), 80.3, 74.8, 55);
    EXPECT_LT(percentile(errors.normalDeg, 0.95), 6);
    EXPECT_NEAR(errors.meanRadius, 55, 0.1);
}

TEST(OrientedContour, HolesPointIntoTheHole) {
    for (const ContourNormals normals : {ContourNormals::Polygon, ContourNormals::Chord}) {
        cv::Mat mask = background(160, 150);
        drawDisc(mask, 80.2, 75.4, 60);
        drawDisc(mask, 78.7, 74.1, 30, 0);
        ContourOptions options;
        options.normals = normals;
        const OrientedContour contour = core::orientedContour(mask, options);
        const CircleErrors outer = circleErrors(contour, 80.2, 75.4, 60);
        const CircleErrors hole = circleErrors(contour, 78.7, 74.1, 30, true);
        EXPECT_GT(outer.normalDeg.size(), 300u);
        EXPECT_GT(hole.normalDeg.size(), 150u);
        EXPECT_EQ(outer.normalDeg.size() + hole.normalDeg.size(), contour.size());
        EXPECT_LT(percentile(outer.normalDeg, 0.95), 24);
        EXPECT_LT(percentile(hole.normalDeg, 0.95), 24);
        EXPECT_NEAR(hole.meanRadius, 30, 0.15);
    }
}

/// Two overlapping discs with holes, one running out of the image, and a bar.
cv::Mat severalShapes(test::RandomValues& random) {
    cv::Mat mask = background(120, 100);
    drawDisc(mask, random.between(30, 60), random.between(30, 60), random.between(15, 28));
    drawDisc(mask, random.between(50, 70), random.between(40, 60), random.between(12, 24));
    drawDisc(mask, random.between(45, 60), random.between(40, 55), random.between(5, 9), 0);
    drawDisc(mask, 118, 20, random.between(8, 14));
    cv::rectangle(mask, {10, 80}, {60, 88}, cv::Scalar(200), cv::FILLED);
    return mask;
}

TEST(OrientedContour, HoldsEveryBoundaryPixelButThoseOnTheImageBorder) {
    test::RandomValues random("boundary pixels");
    ContourOptions options;
    options.offsetPx = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const cv::Mat mask = severalShapes(random);
        std::set<std::pair<int, int>> expected, found;
        for (int y = 1; y + 1 < mask.rows; ++y) {
            for (int x = 1; x + 1 < mask.cols; ++x) {
                const auto at = [&](int dx, int dy) { return mask.at<unsigned char>(y + dy, x + dx) != 0; };
                if (at(0, 0) && !(at(-1, 0) && at(1, 0) && at(0, -1) && at(0, 1)))
                    expected.insert({x, y});
            }
        }
        const OrientedContour contour = core::orientedContour(mask, options);
        for (std::size_t i = 0; i < contour.size(); ++i)
            found.insert({static_cast<int>(contour.x[i]), static_cast<int>(contour.y[i])});
        EXPECT_EQ(found, expected);
    }
}

TEST(OrientedContour, NormalsLeadOutOfTheRegion) {
    test::RandomValues random("outward");
    int out = 0, in = 0, count = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const cv::Mat mask = severalShapes(random);
        const OrientedContour contour = core::orientedContour(mask);
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const auto at = [&](double step) {
                const double angle = static_cast<double>(contour.angleRad[i]);
                const int x = static_cast<int>(std::lround(static_cast<double>(contour.x[i]) + step * std::cos(angle)));
                const int y = static_cast<int>(std::lround(static_cast<double>(contour.y[i]) + step * std::sin(angle)));
                return mask.at<unsigned char>(std::clamp(y, 0, mask.rows - 1), std::clamp(x, 0, mask.cols - 1)) != 0;
            };
            out += !at(2);
            in += at(-2);
            ++count;
        }
    }
    EXPECT_GT(out, 0.98 * count);
    EXPECT_GT(in, 0.98 * count);
}

TEST(OrientedContour, LeavesOutTheImageBorder) {
    cv::Mat mask = background(100, 80);
    cv::rectangle(mask, {0, 30}, {50, 50}, cv::Scalar(255), cv::FILLED); // a forearm cut by the left border
    const OrientedContour contour = core::orientedContour(mask);
    ASSERT_FALSE(contour.empty());
    bool above = false, below = false;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        EXPECT_GT(contour.x[i], 0.4f);
        EXPECT_GT(std::cos(contour.angleRad[i]), -0.9f) << "nothing looks out through the border";
        above = above || contour.y[i] == 29.5f;
        below = below || contour.y[i] == 50.5f;
    }
    EXPECT_TRUE(above && below);
    EXPECT_TRUE(core::orientedContour(cv::Mat(80, 100, CV_8U, cv::Scalar(255))).empty());
}

TEST(OrientedContour, AThinSpurChangesOnlyItsOwnNormals) {
    cv::Mat mask = background(200, 150);
    drawDisc(mask, 70, 75, 40);
    cv::line(mask, {100, 75}, {170, 60}, cv::Scalar(255));
    const OrientedContour contour = core::orientedContour(mask);
    int up = 0, down = 0;
    OrientedContour disc;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        if (contour.x[i] < 105) {
            disc.x.push_back(contour.x[i]);
            disc.y.push_back(contour.y[i]);
            disc.angleRad.push_back(contour.angleRad[i]);
        } else if (contour.x[i] > 115) {
            up += std::sin(contour.angleRad[i]) < -0.7f;
            down += std::sin(contour.angleRad[i]) > 0.7f;
        }
    }
    EXPECT_LT(percentile(circleErrors(disc, 70, 75, 40).normalDeg, 0.95), 24);
    EXPECT_NEAR(up, 55, 5);
    EXPECT_NEAR(down, 55, 5);
}

TEST(OrientedContour, DropsShortOutlines) {
    cv::Mat mask = background(100, 80);
    cv::rectangle(mask, {20, 20}, {22, 22}, cv::Scalar(255), cv::FILLED); // 8 boundary pixels
    mask.at<unsigned char>(50, 50) = 255;
    EXPECT_TRUE(core::orientedContour(mask).empty());
    ContourOptions options;
    options.minLengthPx = 8;
    EXPECT_EQ(core::orientedContour(mask, options).size(), 8u);
}

TEST(OrientedContour, AnyValueButZeroIsForeground) {
    cv::Mat mask = background(100, 80);
    drawDisc(mask, 50, 40, 20, 1);
    EXPECT_GT(core::orientedContour(mask).size(), 80u);
}

TEST(OrientedContour, OfNothingIsEmpty) {
    EXPECT_TRUE(core::orientedContour(cv::Mat()).empty());
    EXPECT_TRUE(core::orientedContour(background(64, 48)).empty());
    EXPECT_EQ(core::orientedContour(background(64, 48)).size(), 0u);
}

TEST(OrientedContour, OfAnotherTypeIsAnError) {
    for (const int type : {CV_8UC3, CV_8S, CV_16U, CV_32F}) {
        try {
            core::orientedContour(cv::Mat(48, 64, type, cv::Scalar::all(1)));
            ADD_FAILURE() << type;
        } catch (const core::Error& error) {
            EXPECT_EQ(error.code(), core::ErrorCode::BadInput);
            EXPECT_EQ(error.field(), "mask");
        }
    }
}

TEST(MaskBounds, AreThoseOfBruteForce) {
    test::RandomValues random("bounds");
    for (int trial = 0; trial < 300; ++trial) {
        const cv::Mat frame = background(1 + random.below(40), 1 + random.below(30));
        // Every other mask is a window of a larger one, whose rows do not follow each other, with pixels set around it.
        cv::Mat larger(frame.rows + 6, frame.cols + 6, CV_8U, cv::Scalar(9));
        cv::Mat mask = trial % 2 ? larger(cv::Rect(3, 3, frame.cols, frame.rows)) : frame;
        mask.setTo(0);
        int left = mask.cols, top = mask.rows, right = -1, bottom = -1;
        for (int i = random.below(5); i > 0; --i) {
            const int x = random.below(mask.cols), y = random.below(mask.rows);
            mask.at<unsigned char>(y, x) = static_cast<unsigned char>(1 + random.below(255));
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
        const cv::Rect bounds = core::maskBounds(mask);
        if (right < 0)
            EXPECT_TRUE(bounds.empty());
        else
            EXPECT_EQ(bounds, cv::Rect(left, top, right - left + 1, bottom - top + 1));
    }
    EXPECT_TRUE(core::maskBounds(cv::Mat()).empty());
}

} // namespace
