// SPDX-License-Identifier: MIT
#include "widgets/document/joint_list.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/recordings/ring_dataset.h"
#include "tests/support/tiny_hands.h"

namespace {

using namespace widgets;
using core::Side;

const core::JointId kA{Side::Left, "a"}, kB{Side::Left, "b"}, kC{Side::Right, "c"};

TEST(JointNames, FourteenAreTheJointsBetweenFingerBones) {
    const auto names = jointNames(JointChoice::Fourteen, nullptr);
    EXPECT_EQ(names.size(), 14u);
    EXPECT_EQ(std::count(names.begin(), names.end(), "thumb_tip"), 0);
    EXPECT_EQ(std::count(names.begin(), names.end(), "thumb_ip"), 1);
    EXPECT_EQ(std::count(names.begin(), names.end(), "little_dip"), 1);
}

TEST(JointNames, TwentyOneHaveWristAndTips) {
    const auto names = jointNames(JointChoice::TwentyOne, nullptr);
    EXPECT_EQ(names.size(), 21u);
    EXPECT_EQ(names.front(), "wrist");
    EXPECT_EQ(std::count(names.begin(), names.end(), "middle_tip"), 1);
}

TEST(JointList, TakesTheHandsOfTheDataset) {
    core::Dataset dataset = test::ringDataset();
    JointList list;
    list.setChoice(JointChoice::Fourteen, dataset);
    EXPECT_EQ(list.joints().size(), 28u);
    dataset.hands = {test::tinyHand(Side::Right)};
    list.setChoice(JointChoice::AllBones, dataset);
    ASSERT_EQ(list.joints().size(), 2u);
    EXPECT_EQ(list.joints()[0], (core::JointId{Side::Right, "forearm"}));
    EXPECT_EQ(list.count(Side::Left), 0);
}

TEST(JointList, NeighbourGoesAroundTheEnd) {
    JointList list;
    list.setCustom({kA, kB, kC});
    EXPECT_EQ(list.neighbour(kC, 1), kA);
    EXPECT_EQ(list.neighbour(kA, -1), kC);
    EXPECT_EQ(list.neighbour(kA, -7), kC);
    EXPECT_EQ(list.neighbour({Side::Right, "unknown"}, 1), kA);
}

TEST(JointList, MovesWithinTheList) {
    JointList list;
    list.setCustom({kA, kB, kC, kA});
    ASSERT_EQ(list.joints().size(), 3u);
    list.move(0, 2);
    EXPECT_EQ(list.joints(), (std::vector{kB, kC, kA}));
    list.move(2, -1);
    EXPECT_EQ(list.joints(), (std::vector{kB, kA, kC}));
    QSignalSpy changed(&list, &JointList::changed);
    list.move(0, -1);
    EXPECT_EQ(changed.count(), 0);
}

TEST(JointList, TextReadsBack) {
    const core::Dataset dataset = test::ringDataset();
    JointList list, other;
    list.setCustom({kC, kA});
    ASSERT_TRUE(other.setFromText(list.toText(), dataset));
    EXPECT_EQ(other.joints(), list.joints());
    list.setChoice(JointChoice::TwentyOne, dataset);
    ASSERT_TRUE(other.setFromText(list.toText(), dataset));
    EXPECT_EQ(other.choice(), JointChoice::TwentyOne);
    EXPECT_FALSE(other.setFromText("nonsense", dataset));
    EXPECT_FALSE(other.setFromText("", dataset));
    EXPECT_EQ(other.choice(), JointChoice::TwentyOne);
}

} // namespace
