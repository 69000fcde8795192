// SPDX-License-Identifier: MIT
#include "core/hand/motion.h"

#include <gtest/gtest.h>

#include "tests/support/two_finger_hand.h"

namespace {

TEST(MeanDisplacement, IsTheSpeedOfAStraightMotion) {
    const std::vector<core::HandModel> hands{test::twoFingerHand(core::Side::Left, {}),
                                             test::twoFingerHand(core::Side::Right, {})};
    core::Motion motion;
    for (int frame = 0; frame < 30; ++frame) {
        core::Pose pose = hands[0].skeleton.restPose();
        pose[0] = 2.0 * frame;
        motion.push_back({pose, hands[1].skeleton.restPose()});
    }
    EXPECT_NEAR(core::meanDisplacementMm(hands, motion, 1), 1, 1e-12); // one hand moves, one rests
    EXPECT_NEAR(core::meanDisplacementMm(hands, motion, 10), 10, 1e-12);
    EXPECT_EQ(core::meanDisplacementMm(hands, motion, 30), 0);
}

} // namespace
