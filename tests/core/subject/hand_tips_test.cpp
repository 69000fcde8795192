// SPDX-License-Identifier: MIT
#include "core/subject/hand_tips.h"

#include <gtest/gtest.h>

#include "core/subject/hand_shape.h"
#include "tests/support/two_finger_hand.h"

namespace {

TEST(HandTips, AreAtTheEndsOfLastBonesAndLeavePosesAsTheyAre) {
    const core::HandModel hand = test::twoFingerHand(core::Side::Right);
    const core::HandModel extended = core::withTips(hand);
    ASSERT_EQ(extended.skeleton.bones.size(), 7u);
    EXPECT_EQ(extended.skeleton.poseSize(), hand.skeleton.poseSize());
    test::RandomValues random("tips");
    const core::Pose pose = test::somePose(hand.skeleton, random);
    const auto before = core::boneTransforms(hand.skeleton, pose);
    const auto after = core::jointPositions(extended.skeleton, pose);
    for (const auto& [last, tip, mm] : {std::tuple("index_pip", "index_tip", 32.0), {"thumb_ip", "thumb_tip", 30.0}}) {
        const auto b = static_cast<std::size_t>(hand.skeleton.boneIndex(last));
        const int t = extended.skeleton.boneIndex(tip);
        ASSERT_GE(t, 0) << tip;
        const Eigen::Vector3d expected = before[b] * Eigen::Vector3d(mm, 0, 0);
        EXPECT_LT((after[static_cast<std::size_t>(t)] - expected).norm(), 1e-9) << tip;
    }
    EXPECT_EQ(core::withTips(extended).skeleton.bones.size(), 7u) << "they are there already";
}

TEST(HandTips, TheirDistanceBecomesTheLengthOfTheLastBone) {
    const core::HandModel hand = test::twoFingerHand(core::Side::Left);
    const core::ShapeSpace space(core::withTips(hand));
    core::HandShape shape = space.modelShape();
    shape[0] = std::log(1.1);
    for (int a = 0; a < space.segmentCount(); ++a)
        if (space.segments()[static_cast<std::size_t>(a)].end == 5) // index_tip
            shape[space.lengthIndex(a)] = 0.2;
    const core::HandModel back = core::withoutTips(space.shaped(shape), hand);
    ASSERT_EQ(back.skeleton.bones.size(), 5u);
    EXPECT_NEAR(back.skeleton.bones[2].lengthMm, 32 * 1.1 * 1.2, 1e-9);
    EXPECT_NEAR(back.skeleton.bones[4].lengthMm, 30 * 1.1, 1e-9);
}

} // namespace
