// SPDX-License-Identifier: MIT
#include "core/annotation/edit_description.h"

#include <gtest/gtest.h>

namespace {

using core::EditDescription;
using core::EditKind;

const core::JointId kRightIndex{core::Side::Right, "index_mcp"};

struct Known {
    const char* label; ///< as annotation files hold it
    EditDescription description;
};
const std::vector<Known> kKnown = {
    {"place right index_mcp in cam3", {.kind = EditKind::Place, .joint = kRightIndex, .camera = "cam3"}},
    {"move right index_mcp in cam 3", {.kind = EditKind::Move, .joint = kRightIndex, .camera = "cam 3"}},
    {"delete right index_mcp in in", {.kind = EditKind::Delete, .joint = kRightIndex, .camera = "in"}},
    {"set to visible: right index_mcp in cam3", {.kind = EditKind::SetState, .joint = kRightIndex, .camera = "cam3"}},
    {"set to unplaceable: right index_mcp in cam3",
     {.kind = EditKind::SetState, .joint = kRightIndex, .camera = "cam3", .state = core::MarkState::Unplaceable}},
    {"note in frame 12", {.kind = EditKind::Note, .firstFrame = 12}},
    {"accept right index_mcp in cam3", {.kind = EditKind::AcceptJoint, .joint = kRightIndex, .camera = "cam3"}},
    {"accept right index_mcp in all views", {.kind = EditKind::AcceptJoint, .joint = kRightIndex}},
    {"accept all joints of frame 7", {.kind = EditKind::AcceptFrame, .firstFrame = 7}},
    {"propose joints of the hand model", {.kind = EditKind::Propose}},
    {"copy pose of frame 4 to frame 5", {.kind = EditKind::CopyPose, .firstFrame = 4, .lastFrame = 5}},
    {"interpolate frames 4 to 9", {.kind = EditKind::Interpolate, .firstFrame = 4, .lastFrame = 9}},
    {"swap left and right in frames 1 to 2", {.kind = EditKind::SwapHands, .firstFrame = 1, .lastFrame = 2}},
    {"swap left and right from frame 3", {.kind = EditKind::SwapHands, .firstFrame = 3}},
    {"delete frames 0 to 0", {.kind = EditKind::DeleteRange, .firstFrame = 0, .lastFrame = 0}},
    {"first pass over frames 0 to 590", {.kind = EditKind::FirstPass, .firstFrame = 0, .lastFrame = 590}},
    {"import", {.kind = EditKind::Import}},
    {"import place left x in y.csv", {.kind = EditKind::Import, .text = "place left x in y.csv"}},
};

TEST(EditDescription, WritesAndReadsTheLabelsOfAnnotationFiles) {
    for (const Known& known : kKnown) {
        EXPECT_EQ(core::editLabel(known.description), known.label);
        EXPECT_EQ(core::parseEditLabel(known.label), known.description) << known.label;
    }
}

TEST(EditDescription, KeepsALabelThatItDoesNotKnowAsItStands) {
    for (const char* label : {"", "place", "place left thumb", "set to gone: left thumb in cam0", "note in frame",
                              "note in frame 007", "note in frame 7 and 8", "delete frames 3", "accept left thumb",
                              "imported", "import ", "copy pose of frame 99999999999 to frame 1", "mark everything"}) {
        EXPECT_EQ(core::parseEditLabel(label), (EditDescription{.text = label})) << label;
        EXPECT_EQ(core::editLabel(core::parseEditLabel(label)), label);
    }
}

} // namespace
