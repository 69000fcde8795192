// SPDX-License-Identifier: MIT
#include "core/annotation/edits.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"

namespace {

using core::AnnotationSet;
using core::Edit;
using core::JointId;
using core::Mark;
using core::MarkKey;
using core::MarkState;
using core::Placement;
using core::Side;
using Eigen::Vector2d;
using Eigen::Vector3d;
using test::kIndex;
using test::kRater;
using test::kWrist;

class Edits : public testing::Test {
protected:
    /// Applies, checks that the inverse restores the set, and leaves the edit applied.
    void perform(const Edit& edit) {
        const AnnotationSet before = m_set;
        core::apply(m_set, edit);
        AnnotationSet back = m_set;
        core::apply(back, core::inverse(edit));
        ASSERT_EQ(back, before) << core::editLabel(edit.description);
    }
    /// Clicks a joint in the first three cameras.
    void click(int frame, const JointId& joint, const Vector3d& point) {
        test::clickEverywhere(m_set, {m_cameras.begin(), m_cameras.begin() + 3}, frame, kRater, joint, point);
    }
    MarkKey key(int frame, const JointId& joint, int camera) { return {frame, kRater, joint, m_cameras[camera].name}; }
    std::optional<Mark> mark(int frame, const JointId& joint, int camera) {
        return core::markAt(m_set, key(frame, joint, camera));
    }

    std::vector<core::Camera> m_cameras = test::cameraRing(8);
    AnnotationSet m_set;
};

TEST_F(Edits, PlacingMovesAndKeepsWhatTheAnnotatorSaid) {
    perform(core::placeEdit(m_set, key(4, kIndex, 3), {10.25, 20.5}));
    EXPECT_EQ(mark(4, kIndex, 3), (Mark{{10.25, 20.5}, Placement::Manual, MarkState::Visible}));
    perform(core::stateEdit(m_set, key(4, kIndex, 3), MarkState::Occluded));
    const Edit move = core::placeEdit(m_set, key(4, kIndex, 3), {11, 21});
    EXPECT_EQ(core::editLabel(move.description), "move left index_mcp in cam3");
    perform(move);
    EXPECT_EQ(mark(4, kIndex, 3), (Mark{{11, 21}, Placement::Manual, MarkState::Occluded}));
    perform(core::stateEdit(m_set, key(4, kIndex, 3), MarkState::Unplaceable));
    EXPECT_FALSE(mark(4, kIndex, 3)->isPlaced());
    EXPECT_TRUE(
        core::stateEdit(m_set, key(4, kIndex, 3), MarkState::Occluded).empty()); // there is no place to be occluded
    const Edit place = core::placeEdit(m_set, key(4, kIndex, 3), {1, 2});
    EXPECT_EQ(core::editLabel(place.description), "place left index_mcp in cam3");
    perform(place);
    EXPECT_EQ(mark(4, kIndex, 3)->state, MarkState::Visible);
    perform(core::removeEdit(m_set, key(4, kIndex, 3)));
    EXPECT_TRUE(m_set.marks.empty());
}

TEST_F(Edits, WhatChangesNothingIsEmpty) {
    perform(core::placeEdit(m_set, key(0, kIndex, 0), {1, 2}));
    EXPECT_TRUE(core::placeEdit(m_set, key(0, kIndex, 0), {1, 2}).empty());
    EXPECT_TRUE(core::removeEdit(m_set, key(0, kIndex, 1)).empty());
    EXPECT_TRUE(core::stateEdit(m_set, key(0, kIndex, 0), MarkState::Visible).empty());
    EXPECT_TRUE(core::stateEdit(m_set, key(0, kIndex, 1), MarkState::Occluded).empty());
    EXPECT_TRUE(core::noteEdit(m_set, 0, "").empty());
    EXPECT_THROW(core::placeEdit(m_set, key(0, kIndex, 0), {NAN, 2}), core::Error);
}

TEST_F(Edits, NotesAreSetChangedAndDeleted) {
    perform(core::noteEdit(m_set, 3, "blurred"));
    EXPECT_EQ(m_set.notes.at(3), "blurred");
    perform(core::noteEdit(m_set, 3, ""));
    EXPECT_TRUE(m_set.notes.empty());
}

TEST_F(Edits, AcceptingPutsAutoMarksOnReprojectionsAndNeverTouchesClicks) {
    const Vector3d point(10, 20, -15);
    click(5, kIndex, point);
    perform(core::stateEdit(m_set, key(5, kIndex, 7), MarkState::Unplaceable));
    const AnnotationSet clicked = m_set;
    perform(core::acceptEdit(m_set, m_cameras, 5, kRater, kIndex, "cam4"));
    EXPECT_EQ(m_set.marks.size(), clicked.marks.size() + 1);
    perform(core::acceptEdit(m_set, m_cameras, 5, kRater, kIndex));
    EXPECT_EQ(m_set.marks.size(), 8u);
    for (const auto& [k, m] : clicked.marks)
        EXPECT_EQ(m_set.marks.at(k), m);
    EXPECT_EQ(mark(5, kIndex, 5)->placement, Placement::Auto);
    EXPECT_LT((mark(5, kIndex, 5)->px - *core::project(m_cameras[5], point)).norm(), 1e-6);
    // Accepted marks do not count: the point still rests on the three clicks.
    const auto joint = core::reconstruct(m_set, m_cameras, 5, kRater, kIndex);
    EXPECT_EQ(joint.manualViews, 3);
    EXPECT_EQ(joint.result.point->inlier.size(), 3u);
    EXPECT_EQ(joint.status, core::JointStatus::Done);
}

TEST_F(Edits, AcceptingTheFrameTakesEveryJointThatHasAPoint) {
    click(5, kIndex, {10, 20, -15});
    click(5, kWrist, {-30, 5, 0});
    perform(core::placeEdit(m_set, key(5, {Side::Left, "wrist"}, 0), {500, 900})); // one view: no point
    perform(core::acceptFrameEdit(m_set, m_cameras, 5, kRater));
    EXPECT_EQ(m_set.marks.size(), 8u + 8u + 1u);
}

TEST_F(Edits, CopiedPosesAreProposalsOnly) {
    click(5, kIndex, {10, 20, -15});
    perform(core::placeEdit(m_set, key(9, kIndex, 0), {300, 300}));
    perform(core::copyPoseEdit(m_set, m_cameras, 5, 9, kRater));
    EXPECT_EQ(mark(9, kIndex, 0)->px, Vector2d(300, 300));
    EXPECT_EQ(mark(9, kIndex, 1)->placement, Placement::Proposed);
    const auto joint = core::reconstruct(m_set, m_cameras, 9, kRater, kIndex);
    EXPECT_FALSE(joint.hasPoint());
    EXPECT_TRUE(core::copyPoseEdit(m_set, m_cameras, 5, 5, kRater).empty());
    EXPECT_TRUE(core::copyPoseEdit(m_set, m_cameras, 5, 10, kRater, std::vector<JointId>{kWrist}).empty());
}

TEST_F(Edits, ProposalsMakeWayForClicksForAcceptanceAndForNewerProposals) {
    const Vector3d point(10, 20, -15), elsewhere(30, -20, 5);
    perform(core::proposeEdit(m_set, m_cameras, 5, kRater, {{kIndex, elsewhere}}));
    ASSERT_EQ(m_set.marks.size(), 8u);
    EXPECT_TRUE(core::acceptEdit(m_set, m_cameras, 5, kRater, kIndex).empty()) << "a guess gives no point";
    EXPECT_TRUE(core::proposeEdit(m_set, m_cameras, 5, kRater, {{kIndex, elsewhere}}).empty()) << "the same again";
    perform(core::proposeEdit(m_set, m_cameras, 5, kRater, {{kIndex, point}}));
    EXPECT_LT((mark(5, kIndex, 3)->px - *core::project(m_cameras[3], point)).norm(), 1e-9);
    perform(core::placeEdit(m_set, key(5, kIndex, 0), *core::project(m_cameras[0], elsewhere)));
    perform(core::placeEdit(m_set, key(5, kIndex, 2), *core::project(m_cameras[2], elsewhere)));
    EXPECT_EQ(mark(5, kIndex, 0)->placement, Placement::Manual);
    perform(core::acceptEdit(m_set, m_cameras, 5, kRater, kIndex));
    EXPECT_EQ(mark(5, kIndex, 3)->placement, Placement::Auto);
    EXPECT_LT((mark(5, kIndex, 3)->px - *core::project(m_cameras[3], elsewhere)).norm(), 1e-6)
        << "the reprojection, not the guess";
    EXPECT_TRUE(core::proposeEdit(m_set, m_cameras, 5, kRater, {{kIndex, point}}).empty()) << "what is accepted stays";
}

TEST_F(Edits, InterpolationFillsOnlyTheFramesBetween) {
    const auto path = [](double t) { return Vector3d(t - 20, 0.04 * t * t, 5); };
    for (const int frame : {0, 10, 16, 30})
        click(frame, kIndex, path(frame));
    const AnnotationSet clicked = m_set;
    perform(core::interpolateEdit(m_set, m_cameras, 10, 20, kRater, core::Interpolation::Cubic));
    EXPECT_EQ(core::annotatedFrames(m_set), (std::vector<int>{0, 10, 11, 12, 13, 14, 15, 16, 30}));
    const auto joint = core::reconstruct(m_set, m_cameras, 13, kRater, kIndex);
    ASSERT_TRUE(joint.proposal);
    EXPECT_LT((*joint.proposal - path(13)).norm(),
              1e-3); // the cubic sees frames 0 and 30 too, and is exact for a parabola
    m_set = clicked;
    perform(core::interpolateEdit(m_set, m_cameras, 0, 30, kRater, core::Interpolation::Linear));
    EXPECT_EQ(core::annotatedFrames(m_set).size(), 31u);
    EXPECT_LT((*core::reconstruct(m_set, m_cameras, 5, kRater, kIndex).proposal - 0.5 * (path(0) + path(10))).norm(),
              1e-3);
}

TEST_F(Edits, SwappingHandsIsItsOwnInverseAndLeavesOtherRatersAlone) {
    click(5, kIndex, {10, 20, -15});
    click(6, kIndex, {10, 20, -15});
    click(6, {Side::Right, "index_mcp"}, {40, 20, -15});
    click(6, kWrist, {50, 0, 0});
    m_set.marks[{6, "bob", kIndex, "cam0"}] = Mark{{1, 1}};
    const AnnotationSet before = m_set;
    perform(core::swapHandsEdit(m_set, kRater, 6));
    EXPECT_EQ(mark(5, kIndex, 0), core::markAt(before, key(5, kIndex, 0)));
    EXPECT_EQ(mark(6, kIndex, 0), core::markAt(before, key(6, {Side::Right, "index_mcp"}, 0)));
    EXPECT_EQ(mark(6, {Side::Left, "wrist"}, 0), core::markAt(before, key(6, kWrist, 0)));
    EXPECT_FALSE(mark(6, kWrist, 0));
    EXPECT_TRUE(core::markAt(m_set, {6, "bob", kIndex, "cam0"}));
    perform(core::swapHandsEdit(m_set, kRater, 6, 6));
    EXPECT_EQ(m_set, before);
}

TEST_F(Edits, DeletingARangeDeletesThatRangeOfThatRater) {
    for (int frame = 0; frame < 6; ++frame) {
        click(frame, kIndex, {10, 20, -15});
        click(frame, kWrist, {50, 0, 0});
    }
    m_set.marks[{3, "bob", kIndex, "cam0"}] = Mark{{1, 1}};
    perform(core::deleteRangeEdit(m_set, kRater, 2, 3, std::vector<JointId>{kIndex}));
    EXPECT_FALSE(mark(2, kIndex, 0));
    EXPECT_TRUE(mark(2, kWrist, 0));
    EXPECT_TRUE(mark(4, kIndex, 0));
    EXPECT_TRUE(core::markAt(m_set, {3, "bob", kIndex, "cam0"}));
    perform(core::deleteRangeEdit(m_set, kRater, 0, 5));
    EXPECT_EQ(m_set.marks.size(), 1u);
}

} // namespace
