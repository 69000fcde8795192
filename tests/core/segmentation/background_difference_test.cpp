// SPDX-License-Identifier: MIT
#include "core/segmentation/background_difference.h"

#include <random>

#include <gtest/gtest.h>

#include "core/segmentation/silhouette.h"
#include "tests/core/segmentation/drawn_scene.h"

namespace core {
namespace {

const cv::Size kRoomSize(320, 240);

/// A floor with a pattern, so that a shadow is not of one colour.
cv::Mat patternedRoom(int seed) {
    cv::Mat room = test::noisyColour(kRoomSize, test::kGrey, 2, seed);
    for (int x = 0; x < kRoomSize.width; x += 40)
        room(cv::Rect(x, 0, 20, kRoomSize.height)) += cv::Scalar(20, 25, 30);
    return room;
}

TEST(BackgroundMask, FindsAHandByItsDifference) {
    const cv::Mat truth = test::discMask(kRoomSize, {150, 120}, 50);
    const cv::Mat picture =
        test::composed(test::noisyColour(kRoomSize, test::kSkin, 2, 2), patternedRoom(3), truth, 0.8);
    EXPECT_GT(maskOverlap(backgroundMask(picture, patternedRoom(1)), truth), 0.97);
}

TEST(BackgroundMask, LeavesTheShadowToTheRoom) {
    const cv::Mat truth = test::discMask(kRoomSize, {120, 120}, 45), shadow = test::discMask(kRoomSize, {215, 120}, 40);
    cv::Mat room = patternedRoom(3), dark;
    room.convertTo(dark, -1, 0.6);
    dark.copyTo(room, shadow);
    const cv::Mat picture = test::composed(test::noisyColour(kRoomSize, test::kSkin, 2, 2), room, truth, 0.8);
    EXPECT_GT(maskOverlap(backgroundMask(picture, patternedRoom(1)), truth), 0.95);
    EXPECT_LT(maskOverlap(differenceMask(picture, patternedRoom(1)), truth), 0.7) << "the shadow differs, too";
}

TEST(BackgroundMask, FindsNothingInAnEmptyRoomOfAnotherExposure) {
    cv::Mat brighter;
    patternedRoom(3).convertTo(brighter, -1, 1.1);
    EXPECT_EQ(cv::countNonZero(backgroundMask(brighter, patternedRoom(1))), 0);
}

TEST(MedianPicture, IsTheMedianOfEveryPixelAndChannel) {
    std::mt19937 random(1);
    std::vector<cv::Mat> pictures(5);
    for (cv::Mat& picture : pictures) {
        picture.create(7, 9, CV_8UC3);
        cv::randu(picture, 0, 256);
    }
    const cv::Mat median = medianPicture(pictures);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x)
            for (int k = 0; k < 3; ++k) {
                std::vector<int> values;
                for (const cv::Mat& picture : pictures)
                    values.push_back(picture.at<cv::Vec3b>(y, x)[k]);
                std::sort(values.begin(), values.end());
                EXPECT_EQ(median.at<cv::Vec3b>(y, x)[k], values[2]);
            }
}

TEST(MedianPicture, ForgetsWhatMovesThroughTheRoom) {
    std::vector<cv::Mat> pictures;
    for (int i = 0; i < 9; ++i) {
        const cv::Mat hand = test::discMask(kRoomSize, {20.0 + 35 * i, 120}, 25);
        pictures.push_back(test::composed(test::noisyColour(kRoomSize, test::kSkin, 0, 1),
                                          cv::Mat(kRoomSize, CV_8UC3, test::kGrey), hand, 0));
    }
    EXPECT_EQ(cv::norm(medianPicture(pictures), cv::Mat(kRoomSize, CV_8UC3, test::kGrey), cv::NORM_INF), 0);
    EXPECT_TRUE(medianPicture({}).empty());
}

} // namespace
} // namespace core
