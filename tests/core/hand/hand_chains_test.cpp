// SPDX-License-Identifier: MIT
#include "core/hand/hand_chains.h"

#include <gtest/gtest.h>

namespace {

TEST(HandChains, LeadFromTheTipToTheFirstJointOfEachFinger) {
    for (const std::string_view finger : core::kFingers) {
        std::optional<std::string> joint = std::string(finger) + "_tip";
        int bones = 0;
        for (; core::previousJoint(*joint); joint = core::previousJoint(*joint))
            ++bones;
        EXPECT_EQ(*joint, std::string(finger) + "_cmc");
        EXPECT_EQ(bones, finger == "thumb" ? 3 : 4);
    }
}

TEST(HandChains, EndAtTheWristAndKnowNoOtherNames) {
    for (const char* name :
         {"wrist", "forearm", "index_cmc", "index_ip", "thumb_pip", "thumb_dip", "toe_tip", "", "_tip", "index"})
        EXPECT_FALSE(core::previousJoint(name)) << name;
    EXPECT_EQ(core::previousJoint("thumb_ip"), "thumb_mcp");
    EXPECT_EQ(core::previousJoint("little_dip"), "little_pip");
}

} // namespace
