// SPDX-License-Identifier: MIT
#include "core/segmentation/cleaning.h"

#include <queue>

#include <gtest/gtest.h>

#include "tests/core/segmentation/drawn_scene.h"

namespace core {
namespace {

/// Areas of the parts of a mask by flood filling, largest first: an oracle for connectivity 8.
std::vector<int> areasByFilling(cv::Mat mask) {
    std::vector<int> areas;
    mask = mask.clone();
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x) {
            if (mask.at<uchar>(y, x) == 0)
                continue;
            int area = 0;
            std::queue<cv::Point> open;
            open.emplace(x, y);
            mask.at<uchar>(y, x) = 0;
            while (!open.empty()) {
                const cv::Point at = open.front();
                open.pop();
                ++area;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const cv::Point next(at.x + dx, at.y + dy);
                        if (next.inside({0, 0, mask.cols, mask.rows}) && mask.at<uchar>(next) != 0) {
                            mask.at<uchar>(next) = 0;
                            open.push(next);
                        }
                    }
            }
            areas.push_back(area);
        }
    std::sort(areas.rbegin(), areas.rend());
    return areas;
}

cv::Mat twoHandsAndSpecks() {
    cv::Mat mask = test::discMask({400, 300}, {100, 150}, 60) | test::discMask({400, 300}, {290, 150}, 50);
    mask |= test::discMask({400, 300}, {195, 40}, 6) | test::discMask({400, 300}, {370, 280}, 9);
    return mask;
}

TEST(Cleaning, KeepsTheLargestPartsAndDropsSpecks) {
    const cv::Mat mask = twoHandsAndSpecks();
    const std::vector<int> before = areasByFilling(mask), after = areasByFilling(cleaned(mask));
    ASSERT_EQ(before.size(), 4u);
    ASSERT_EQ(after.size(), 2u);
    EXPECT_EQ(after[0], before[0]);
    EXPECT_EQ(after[1], before[1]);
}

TEST(Cleaning, KeepsASmallPartThatIsSurelyOfAHand) {
    cv::Mat kept = cv::Mat::zeros(300, 400, CV_8U);
    kept.at<uchar>(40, 195) = 255;
    EXPECT_EQ(areasByFilling(cleaned(twoHandsAndSpecks(), {}, kept)).size(), 3u);
}

TEST(Cleaning, FillsSmallHolesAndKeepsRealOnes) {
    const cv::Mat hand = test::discMask({300, 300}, {150, 150}, 100);
    const cv::Mat pinhole = test::discMask({300, 300}, {120, 150}, 4), gap = test::discMask({300, 300}, {190, 150}, 12);
    const cv::Mat result = cleaned(hand & ~pinhole & ~gap);
    EXPECT_EQ(cv::countNonZero(result != (hand & ~gap)), 0);
}

TEST(Cleaning, TakesWhatIsCutOffByTheBorderForOutside) {
    cv::Mat mask(100, 100, CV_8U, cv::Scalar(255));
    mask(cv::Rect(40, 0, 3, 4)).setTo(0); // a dent at the border, smaller than a hole that is filled
    EXPECT_EQ(cv::countNonZero(cleaned(mask) != mask), 0);
}

TEST(Cleaning, LeavesAnEmptyMaskEmpty) {
    EXPECT_EQ(cv::countNonZero(cleaned(cv::Mat::zeros(20, 30, CV_8U))), 0);
}

} // namespace
} // namespace core
