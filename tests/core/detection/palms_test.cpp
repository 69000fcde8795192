// SPDX-License-Identifier: MIT
#include "core/detection/palms.h"

#include <gtest/gtest.h>

#include "core/detection/hand_detector.h"

namespace {

using Eigen::Vector2d;

TEST(Palms, AreDecodedWhereTheyLieInTheWindow) {
    const cv::Mat picture = cv::Mat::zeros(1920, 1080, CV_8UC3);
    const core::Letterbox input = core::letterbox(picture, {270, 405, 540, 540});
    EXPECT_DOUBLE_EQ(input.scale, 192.0 / 540);
    std::vector<float> boxes(core::kPalmAnchors * core::kPalmNumbers), logits(core::kPalmAnchors, -20);
    // anchor of cell (5, 7) of 24 x 24 cells, second of its two
    const std::size_t anchor = 2 * (7 * 24 + 5) + 1;
    logits[anchor] = 2;
    float* numbers = &boxes[anchor * core::kPalmNumbers];
    numbers[0] = 8; // one cell to the right
    numbers[2] = numbers[3] = 32;
    numbers[4 + 1] = 10;  // wrist below
    numbers[8 + 1] = -10; // middle finger's base above the anchor
    const std::vector<core::Palm> palms = core::decodePalms(boxes, logits, input, 0.5);
    ASSERT_EQ(palms.size(), 1u);
    const double px = 540.0 / 192;
    EXPECT_NEAR(palms[0].score, 1 / (1 + std::exp(-2.0)), 1e-9);
    EXPECT_NEAR((palms[0].centrePx - Vector2d(269.5 + 52 * px, 404.5 + 60 * px)).norm(), 0, 1e-9);
    EXPECT_NEAR(palms[0].sizePx.x(), 90, 1e-9);
    const core::HandPlace place = core::placeOf(palms[0]);
    EXPECT_NEAR((place.up - Vector2d(0, -1)).norm(), 0, 1e-9);
    EXPECT_NEAR(place.sidePx, 2.6 * 90, 1e-9);
    EXPECT_NEAR((place.centrePx - palms[0].centrePx - Vector2d(0, -45)).norm(), 0, 1e-9);
}

TEST(Palms, OfAWideWindowAreCentredInTheInput) {
    cv::Mat picture = cv::Mat::zeros(100, 400, CV_8UC3);
    picture(cv::Rect(0, 0, 100, 100)).setTo(cv::Scalar(255, 0, 0)); // blue
    const core::Letterbox input = core::letterbox(picture, {0, 0, 400, 100});
    EXPECT_EQ(input.image.at<cv::Vec3f>(96, 20), cv::Vec3f(0, 0, 1)) << "RGB";
    EXPECT_EQ(input.image.at<cv::Vec3f>(40, 20), cv::Vec3f(0, 0, 0)) << "above the window";
    const Vector2d centre = Vector2d(96, 96) / input.scale + input.offsetPx;
    EXPECT_NEAR((centre - Vector2d(199.5, 49.5)).norm(), 0, 1e-9);
}

TEST(Palms, ThatOverlapLeaveTheSurestOne) {
    const auto palm = [](double score, double x) { return core::Palm{score, {x, 50}, {40, 40}, {x, 70}, {x, 40}}; };
    const auto kept = core::withoutOverlaps({palm(0.6, 50), palm(0.9, 55), palm(0.7, 200)});
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].score, 0.9);
    EXPECT_EQ(kept[1].score, 0.7);
}

TEST(Palms, AreSearchedInTilesThatCoverThePicture) {
    EXPECT_TRUE(core::searchTiles({720, 720}, 540).empty());
    const std::vector<cv::Rect> tiles = core::searchTiles({1080, 1920}, 540);
    for (const cv::Rect& tile : tiles)
        EXPECT_EQ(tile & cv::Rect(0, 0, 1080, 1920), cv::Rect(tile.tl(), cv::Size(540, 540)));
    constexpr int kHand = 135; // what one tile cuts lies whole in another one
    for (int y = 0; y + kHand <= 1920; y += 9)
        for (int x = 0; x + kHand <= 1080; x += 9) {
            const cv::Rect hand(x, y, kHand, kHand);
            EXPECT_TRUE(
                std::any_of(tiles.begin(), tiles.end(), [&](const cv::Rect& tile) { return (tile & hand) == hand; }))
                << x << " " << y;
        }
}

TEST(HandPlace, CropsWhatItShowsUpright) {
    for (const double side : {150.0, 224.0, 700.0}) {
        core::HandPlace place;
        place.centrePx = {500.3, 420.8};
        place.up = Vector2d(0.6, -0.8);
        place.sidePx = side;
        cv::Mat picture = cv::Mat::zeros(900, 1100, CV_8UC3);
        // a wide red ramp along the fingers' direction: its value tells where a pixel comes from
        for (int y = 0; y < picture.rows; ++y)
            for (int x = 0; x < picture.cols; ++x) {
                const double along = (Vector2d(x, y) - place.centrePx).dot(place.up) / side;
                const double across = (Vector2d(x, y) - place.centrePx).dot(place.right()) / side;
                picture.at<cv::Vec3b>(y, x) = {0, cv::saturate_cast<uchar>(128 + 200 * across),
                                               cv::saturate_cast<uchar>(128 + 200 * along)};
            }
        const cv::Mat crop = core::cropOf(picture, place, 224);
        for (const cv::Point at : {cv::Point(60, 50), cv::Point(170, 112), cv::Point(112, 160)}) {
            const cv::Vec3f colour = crop.at<cv::Vec3f>(at) * 255;
            EXPECT_NEAR(colour[0], 128 + 200 * (0.5 - (at.y + 0.5) / 224), 2.0) << side << " " << at.x << " " << at.y;
            EXPECT_NEAR(colour[1], 128 + 200 * ((at.x + 0.5) / 224 - 0.5), 2.0) << side << " " << at.x << " " << at.y;
        }
    }
}

TEST(HandPlace, OfLandmarksTurnsWithThem) {
    core::LandmarkPixels hand;
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i)
        hand[i] = {10.0 * static_cast<double>(i / 4), -20.0 * static_cast<double>(i % 4)};
    hand[core::kWristLandmark] = {25, 60};
    const core::HandPlace place = core::placeOf(hand);
    core::LandmarkPixels turned;
    Eigen::Matrix2d turn;
    turn << 0, -1, 1, 0;
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i)
        turned[i] = turn * hand[i] + Vector2d(300, 200);
    const core::HandPlace other = core::placeOf(turned);
    EXPECT_NEAR(other.sidePx, place.sidePx, 1e-9);
    EXPECT_NEAR((other.up - turn * place.up).norm(), 0, 1e-9);
    EXPECT_NEAR((other.centrePx - turn * place.centrePx - Vector2d(300, 200)).norm(), 0, 1e-9);
}

} // namespace
