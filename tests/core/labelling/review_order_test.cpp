// SPDX-License-Identifier: MIT
#include "core/labelling/review_order.h"

#include <gtest/gtest.h>

namespace {

using core::ReviewFrame;
using core::ReviewItem;

std::vector<int> numbers(const std::vector<ReviewItem>& items) {
    std::vector<int> list;
    for (const ReviewItem& item : items)
        list.push_back(item.frame);
    return list;
}

TEST(ReviewOrder, PutsDoubtfulFramesWithManyUnsureNeighboursFirst) {
    // 0..2 hang together, 10 stands alone between sure ones though its doubt is the greatest
    const std::vector<ReviewFrame> frames{{0, 0.6}, {1, 0.7},  {2, 0.6},  {3, 0.05},
                                          {9, 0.1}, {10, 0.9}, {11, 0.1}, {12, 0.1}};
    const auto order = core::reviewOrder(frames);
    EXPECT_EQ(numbers(order), (std::vector{1, 0, 2, 10, 9, 11, 3, 12}));
    EXPECT_EQ(order[0].neighbours, 2);
    EXPECT_EQ(order[3].neighbours, 0);
    EXPECT_DOUBLE_EQ(order[3].teach, 0.9);
}

TEST(ReviewOrder, LeavesReviewedFramesOutAndDoesNotTrackThroughThem) {
    const std::vector<ReviewFrame> frames{{4, 0.8}, {3, 0.5, true}, {2, 0.8}, {1, 0.8}};
    const auto order = core::reviewOrder(frames);
    EXPECT_EQ(numbers(order), (std::vector{1, 2, 4}));
    EXPECT_EQ(order[0].neighbours, 1);
    EXPECT_EQ(order[2].neighbours, 0);
}

TEST(ReviewOrder, DoesNotTrackOverGaps) {
    core::ReviewOptions options;
    options.mostGapFrames = 14;
    const auto near = core::reviewOrder({{0, 0.5}, {14, 0.5}}, options);
    const auto far = core::reviewOrder({{0, 0.5}, {15, 0.5}}, options);
    EXPECT_EQ(near[0].neighbours, 1);
    EXPECT_EQ(far[0].neighbours, 0);
}

TEST(ReviewOrder, ANeighbourCountsLessTheFartherItIs) {
    core::ReviewOptions options;
    options.reachFrames = 10;
    const auto order = core::reviewOrder({{0, 0.5}, {10, 0.8}}, options);
    EXPECT_EQ(order[0].frame, 10);
    EXPECT_DOUBLE_EQ(order[0].teach, 0.8 * (1 + 0.5 * 0.5));
    EXPECT_DOUBLE_EQ(order[1].teach, 0.5 * (1 + 0.8 * 0.5));
}

TEST(ReviewProgress, ExpectsOfFramesWhatThoseOfLikeDoubtWereMovedBy) {
    const std::vector<ReviewFrame> frames{
        {0, 0.1, true, 0.5}, {1, 0.1, true, 0.7}, {2, 0.9, true, 8.0}, {3, 0.1}, {4, 0.9}};
    const auto progress = core::reviewProgress(frames);
    EXPECT_EQ(progress.left, 2);
    EXPECT_EQ(progress.doubtful, 1);
    ASSERT_TRUE(progress.expectedErrorMm);
    EXPECT_NEAR(*progress.expectedErrorMm, (0.6 + 8.0) / 2, 0.05);
}

TEST(ReviewProgress, ExpectsNothingBeforeThreeFramesSayHowFarTheyWereMoved) {
    EXPECT_FALSE(
        core::reviewProgress({{0, 0.1, true, 0.5}, {1, 0.1, true, 0.7}, {2, 0.5, true}, {3, 0.1}}).expectedErrorMm);
    EXPECT_FALSE(core::reviewProgress({}).expectedErrorMm);
}

TEST(ReviewProgress, ExpectsNothingWhileFramesWereOnlyAccepted) {
    std::vector<ReviewFrame> frames{{0, 0.1, true, 0}, {1, 0.1, true, 0}, {2, 0.5, true, 0}, {3, 0.1}};
    EXPECT_FALSE(core::reviewProgress(frames).expectedErrorMm);
    EXPECT_FALSE(core::reviewProgress(frames).isCorrected);
    frames[1].movedMm = 0.4;
    EXPECT_TRUE(core::reviewProgress(frames).isCorrected);
    ASSERT_TRUE(core::reviewProgress(frames).expectedErrorMm);
    EXPECT_GT(*core::reviewProgress(frames).expectedErrorMm, 0.1);
}

} // namespace
