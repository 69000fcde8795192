// SPDX-License-Identifier: MIT
#include "widgets/session/navigation.h"

#include <gtest/gtest.h>

namespace {

using namespace widgets;
using core::Side;

class NavigationTest : public testing::Test {
protected:
    NavigationTest() { joints.setCustom({{Side::Left, "a"}, {Side::Left, "b"}, {Side::Right, "a"}}); }

    static core::HandCoverage done(int count) { return {count, 0, 0, 0}; }
    static core::HandCoverage bad() { return {0, 1, 1, 0}; }

    JointList joints;
    const FrameCoverage coverage{{3, {{Side::Left, done(2)}, {Side::Right, done(1)}}},
                                 {4, {{Side::Left, done(2)}}},
                                 {9, {{Side::Right, bad()}}},
                                 {12, {{Side::Left, bad()}, {Side::Right, done(1)}}}};
};

TEST_F(NavigationTest, NextBadFrameSkipsGoodOnes) {
    EXPECT_EQ(nextBadFrame(coverage, 0, Direction::Forward), 9);
    EXPECT_EQ(nextBadFrame(coverage, 9, Direction::Forward), 12);
    EXPECT_EQ(nextBadFrame(coverage, 12, Direction::Forward), std::nullopt);
    EXPECT_EQ(nextBadFrame(coverage, 12, Direction::Back), 9);
    EXPECT_EQ(nextBadFrame(coverage, 9, Direction::Back), std::nullopt);
}

TEST_F(NavigationTest, NextAnnotatedFrameSkipsFramesWithoutMarks) {
    EXPECT_EQ(nextAnnotatedFrame(coverage, 3, Direction::Forward), 4);
    EXPECT_EQ(nextAnnotatedFrame(coverage, 4, Direction::Back), 3);
    EXPECT_EQ(nextAnnotatedFrame(coverage, 3, Direction::Back), std::nullopt);
    EXPECT_EQ(nextAnnotatedFrame({}, 3, Direction::Back), std::nullopt);
}

TEST_F(NavigationTest, UnlabelledFramesHaveAJointThatIsNotDone) {
    EXPECT_EQ(nextUnlabelledFrame(coverage, joints, 20, 2, Direction::Forward), 4);
    EXPECT_EQ(nextUnlabelledFrame(coverage, joints, 20, 4, Direction::Back), 2);
    EXPECT_EQ(nextUnlabelledFrame(coverage, joints, 4, 2, Direction::Forward), std::nullopt);
    EXPECT_EQ(nextUnlabelledFrame(coverage, joints, 20, 0, Direction::Back), std::nullopt);
}

} // namespace
