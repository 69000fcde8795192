// SPDX-License-Identifier: MIT
#include "core/segmentation/colour_mask.h"

#include <gtest/gtest.h>

#include "core/segmentation/silhouette.h"
#include "tests/core/segmentation/drawn_scene.h"

namespace core {
namespace {

const cv::Size kBackdropSize(320, 240);

cv::Mat handBefore(const cv::Mat& back, const cv::Mat& truth) {
    return test::composed(test::noisyColour(kBackdropSize, test::kSkin, 3, 2), back, truth, 0.8);
}

/// A backdrop that is lit from the left.
cv::Mat unevenGreen() {
    cv::Mat back = test::noisyColour(kBackdropSize, test::kGreen, 3, 1);
    for (int x = 0; x < kBackdropSize.width; ++x)
        back.col(x) *= 1.15 - 0.3 * x / kBackdropSize.width;
    return back;
}

TEST(ChromaMask, FindsTheHandBeforeAnUnevenlyLitBackdrop) {
    const cv::Mat truth = test::discMask(kBackdropSize, {150, 120}, 60);
    EXPECT_GT(maskOverlap(chromaMask(handBefore(unevenGreen(), truth)), truth), 0.98);
    EXPECT_GT(maskOverlap(chromaMask(handBefore(unevenGreen(), truth), test::kGreen), truth), 0.98);
}

TEST(ChromaMask, FindsNothingBeforeAnEmptyBackdrop) {
    EXPECT_EQ(cv::countNonZero(chromaMask(unevenGreen())), 0);
}

TEST(ChromaMask, TakesTheColourThatIsGivenForTheBackdrop) {
    const cv::Mat truth = test::discMask(kBackdropSize, {150, 120}, 60);
    const cv::Mat wrong = chromaMask(handBefore(unevenGreen(), truth), test::kSkin);
    EXPECT_LT(maskOverlap(wrong, truth), 0.2) << "the hand has the backdrop's colour";
}

TEST(BorderColour, IsTheMostFrequentOneAtTheBorder) {
    cv::Mat picture(kBackdropSize, CV_8UC3, test::kGreen);
    picture(cv::Rect(40, 40, 240, 160)).setTo(test::kSkin);
    picture(cv::Rect(100, 0, 60, 240)).setTo(test::kGrey); // an arm that leaves the picture
    EXPECT_EQ(borderColour(picture), test::kGreen);
}

TEST(SkinMask, FindsSkinBesideColoursThatAreNot) {
    const cv::Mat truth = test::discMask(kBackdropSize, {100, 120}, 55);
    cv::Mat back = test::noisyColour(kBackdropSize, test::kGrey, 3, 1);
    back(cv::Rect(200, 40, 80, 160)) = cv::Scalar(150, 90, 40); // blue cloth
    EXPECT_GT(maskOverlap(skinMask(handBefore(back, truth)), truth), 0.97);
    EXPECT_EQ(cv::countNonZero(skinMask(back)), 0);
}

} // namespace
} // namespace core
