// SPDX-License-Identifier: MIT
#include "core/benchmark/joint_errors.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/tiny_hands.h"

namespace core {
namespace {

const JointId kA{Side::Left, "a"};
const JointId kB{Side::Left, "b"};
const JointId kC{Side::Right, "a"};

TEST(JointErrors, AreOverTheJointsThatBothHave) {
    const JointPositions estimate = {{kA, {0, 0, 0}}, {kB, {1, 1, 1}}};
    const JointPositions reference = {{kA, {3, 4, 0}}, {kC, {9, 9, 9}}, {kB, {1, 1, 2}}};
    const JointErrors errors = jointErrors({kA, kB, kC}, estimate, reference);
    EXPECT_DOUBLE_EQ(errors.perJointMm[0], 5);
    EXPECT_DOUBLE_EQ(errors.perJointMm[1], 1);
    EXPECT_TRUE(std::isnan(errors.perJointMm[2]));
    EXPECT_DOUBLE_EQ(errors.meanMm, 3);
    EXPECT_TRUE(std::isnan(jointErrors({kC}, estimate, reference).meanMm));
}

TEST(JointErrors, NamesFollowHandsAndBones) {
    const std::vector<HandModel> hands = test::tinyHands();
    const std::vector<JointId> expected = {
        {Side::Left, "forearm"}, {Side::Left, "index_mcp"}, {Side::Right, "forearm"}, {Side::Right, "index_mcp"}};
    EXPECT_EQ(jointNames(hands), expected);
    const HandPoses poses = test::tinyMotion(10)[9];
    const JointPositions positions = namedJointPositions(hands, poses);
    ASSERT_EQ(positions.size(), 4u);
    const auto right = jointPositions(hands[1].skeleton, poses[1]);
    EXPECT_EQ(positions.at({Side::Right, "index_mcp"}), right[1]);
}

TEST(NamedJointPositions, LeaveOutHandsWithoutAPose) {
    const std::vector<HandModel> hands = test::tinyHands();
    HandPoses poses = test::tinyMotion(4)[3];
    const JointPositions both = namedJointPositions(hands, poses);
    poses[0] = Pose();
    const JointPositions right = namedJointPositions(hands, poses);
    EXPECT_EQ(right.size(), both.size() / 2);
    for (const auto& [joint, xyz] : right) {
        EXPECT_EQ(joint.hand, hands[1].side);
        EXPECT_EQ(xyz, both.at(joint));
    }
    EXPECT_TRUE(namedJointPositions(hands, {}).empty());
}

} // namespace
} // namespace core
