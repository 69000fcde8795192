// SPDX-License-Identifier: MIT
#include "core/annotation/annotation_set.h"

#include <limits>

#include <gtest/gtest.h>

namespace {

using core::JointId;
using core::Side;

core::AnnotationSet sample() {
    core::AnnotationSet set;
    for (const int frame : {7, 2, 40}) {
        for (const char* rater : {"ann", "ann b", "bob"}) {
            for (const char* joint : {"index_mcp", "index_mcp2", "wrist"})
                for (const char* camera : {"cam0", "cam1"})
                    set.marks[{frame, rater, {Side::Right, joint}, camera}] = {};
        }
    }
    return set;
}

int count(const core::MarkRange& range) {
    return static_cast<int>(std::distance(range.begin(), range.end()));
}

TEST(AnnotationSet, ListsAnnotatedFramesInOrder) {
    EXPECT_EQ(core::annotatedFrames(sample()), (std::vector<int>{2, 7, 40}));
    EXPECT_TRUE(core::annotatedFrames({}).empty());
}

TEST(AnnotationSet, RangesHoldTheMarksOfTheirFrameRaterAndJointOnly) {
    const core::AnnotationSet set = sample();
    EXPECT_EQ(count(core::marksOfFrame(set, 7)), 18);
    EXPECT_EQ(count(core::marksOfFrame(set, 3)), 0);
    EXPECT_EQ(count(core::marksOfFrame(set, 7, "ann")), 6); // not those of "ann b"
    EXPECT_EQ(count(core::marksOfJoint(set, 7, "ann", {Side::Right, "index_mcp"})), 2);
    EXPECT_EQ(count(core::marksOfJoint(set, 7, "ann", {Side::Left, "index_mcp"})), 0);
    EXPECT_EQ(count(core::marksOfFrames(set, 3, 40)), 36);
    EXPECT_EQ(count(core::marksOfFrames(set, 3, std::numeric_limits<int>::max())), 36);
    EXPECT_EQ(count(core::marksOfFrames(set, 40, 3)), 0);
    for (const auto& [key, mark] : core::marksOfJoint(set, 40, "bob", {Side::Right, "wrist"})) {
        EXPECT_EQ(key.frame, 40);
        EXPECT_EQ(key.rater, "bob");
        EXPECT_EQ(key.joint.joint, "wrist");
    }
}

TEST(AnnotationSet, AFrameWithoutANoteHasAnEmptyOne) {
    core::AnnotationSet set = sample();
    set.notes[7] = "blurred";
    EXPECT_EQ(core::noteAt(set, 7), "blurred");
    EXPECT_EQ(core::noteAt(set, 8), "");
    EXPECT_EQ(set.notes.size(), 1u) << "asking adds none";
}

TEST(AnnotationSet, NamesOfPlacementsAndStatesReadBack) {
    for (const auto placement : {core::Placement::Manual, core::Placement::Auto, core::Placement::Proposed})
        EXPECT_EQ(core::placementFromName(core::placementName(placement)), placement);
    for (const auto state : {core::MarkState::Visible, core::MarkState::Occluded, core::MarkState::Unplaceable})
        EXPECT_EQ(core::stateFromName(core::stateName(state)), state);
    EXPECT_FALSE(core::placementFromName("Manual"));
    EXPECT_FALSE(core::stateFromName(""));
}

} // namespace
