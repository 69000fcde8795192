// SPDX-License-Identifier: MIT
#include "core/labelling/proposal_review.h"

#include <set>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "tests/support/camera_ring.h"

namespace {

using core::DoubtReason;
using core::JointId;
using core::Side;

const std::string kRater = "ann";

/// A stiff hand of a wrist and four fingers' bones that moves 4 mm a frame, proposed in every frame.
class ProposalReviewTest : public testing::Test {
protected:
    const std::vector<core::Camera> cameras = test::cameraRing(6);
    core::AnnotationSet set, proposed;
    core::ProposalReview review{cameras, kRater};

    static std::vector<core::JointPoint> hand(Side side, int frame) {
        const double across = side == Side::Left ? -60 : 60;
        std::vector<core::JointPoint> joints{{{side, "wrist"}, {across + 4.0 * frame, 0, 0}}};
        double at = 0;
        for (const char* finger : {"index", "middle", "ring", "little"}) {
            at += 12;
            double along = 60;
            for (const char* joint : {"mcp", "pip", "dip", "tip"}) {
                joints.push_back({{side, std::string(finger) + "_" + joint}, {across + 4.0 * frame + at, along, 5}});
                along += 25;
            }
        }
        return joints;
    }
    void make(const core::Edit& edit) {
        core::apply(set, edit);
        core::followProposals(proposed, edit);
        std::set<int> frames;
        for (const core::MarkChange& change : edit.marks)
            frames.insert(change.key.frame);
        for (const int frame : frames)
            review.look(set, proposed, frame);
    }
    void propose(int frame, const std::vector<core::JointPoint>& joints, double doubt) {
        core::Edit edit = core::proposeEdit(set, cameras, frame, kRater, joints);
        for (core::MarkChange& change : edit.marks)
            change.after->likelihood = 1 - doubt;
        make(edit);
    }
    void proposeFrames(int count, double doubt = 0.05) {
        for (int frame = 0; frame < count; ++frame)
            for (const Side side : {Side::Left, Side::Right})
                propose(frame, hand(side, frame), doubt);
    }
    void click(int frame, const JointId& joint, const Eigen::Vector3d& at, int views = 3) {
        for (int camera = 0; camera < views; ++camera) {
            const core::Camera& seen = cameras[static_cast<std::size_t>(camera)];
            make(core::placeEdit(set, {frame, kRater, joint, seen.name}, *core::project(seen, at)));
        }
    }
    core::ProposedFrame frame(int number) const {
        for (const core::ProposedFrame& found : review.frames())
            if (found.frame == number)
                return found;
        core::ProposedFrame none;
        none.frame = -1;
        return none;
    }
};

TEST_F(ProposalReviewTest, TakesTheDoubtOfTheProgramWhereNothingElseIsOdd) {
    proposeFrames(6);
    propose(3, hand(Side::Right, 3), 0.4);
    ASSERT_EQ(review.frames().size(), 6u);
    EXPECT_NEAR(frame(2).doubt, 0.05, 1e-9);
    EXPECT_NEAR(frame(3).doubt, 0.4, 1e-9);
    EXPECT_EQ(frame(3).reason, DoubtReason::Unsure);
    EXPECT_EQ(frame(3).joint.hand, Side::Right);
    EXPECT_NEAR(frame(3).openHands.at(Side::Left), 0.05, 1e-9);
    EXPECT_NEAR(frame(3).openHands.at(Side::Right), 0.4, 1e-9);
    EXPECT_FALSE(frame(3).isReviewed);
}

TEST_F(ProposalReviewTest, NamesTheBoneThatIsLongerThanUsual) {
    proposeFrames(6);
    auto joints = hand(Side::Left, 4);
    const JointId tip{Side::Left, "ring_tip"};
    for (core::JointPoint& joint : joints)
        if (joint.joint == tip)
            joint.pointInWorld.y() += 10;
    propose(4, joints, 0.05);
    EXPECT_EQ(frame(4).reason, DoubtReason::BoneLength);
    EXPECT_EQ(frame(4).joint, tip);
    EXPECT_NEAR(frame(4).value, 0.4, 1e-4);
    EXPECT_GT(frame(4).doubt, 0.5);
    propose(4, joints, 0.95); // the program says more, and the joint stays the first to look at
    EXPECT_EQ(frame(4).reason, DoubtReason::Unsure);
    EXPECT_EQ(frame(4).joint, tip);
}

TEST_F(ProposalReviewTest, MissesAHandAndJointsThatMostFramesHave) {
    for (int number = 0; number < 6; ++number) {
        propose(number, hand(Side::Left, number), 0.05);
        auto right = hand(Side::Right, number);
        if (number == 2)
            continue;
        if (number == 4)
            right.resize(10);
        propose(number, right, 0.05);
    }
    EXPECT_EQ(frame(2).reason, DoubtReason::HandMissing);
    EXPECT_EQ(frame(2).joint.hand, Side::Right);
    EXPECT_EQ(frame(2).openHands.count(Side::Right), 0u);
    EXPECT_EQ(frame(4).reason, DoubtReason::JointsMissing);
    EXPECT_EQ(frame(4).value, 7);
    EXPECT_EQ(frame(3).reason, DoubtReason::Unsure);
}

TEST_F(ProposalReviewTest, DoubtsAHandThatIsNotWhereItsNeighboursHaveIt) {
    proposeFrames(6);
    propose(3, hand(Side::Left, 20), 0.05); // 68 mm away
    EXPECT_EQ(frame(3).reason, DoubtReason::Jump);
    EXPECT_NEAR(frame(3).value, 68, 0.1);
    EXPECT_EQ(frame(3).joint.hand, Side::Left);
}

TEST_F(ProposalReviewTest, AFrameIsReviewedWhenNoJointWaitsAndSaysHowFarItWasMoved) {
    proposeFrames(4);
    const auto left = hand(Side::Left, 1);
    click(1, left[2].joint, left[2].pointInWorld + Eigen::Vector3d(0, 0, 6));
    EXPECT_FALSE(frame(1).isReviewed);
    make(core::acceptProposalsEdit(set, cameras, 1, kRater));
    EXPECT_TRUE(frame(1).isReviewed);
    ASSERT_TRUE(frame(1).movedMm);
    EXPECT_NEAR(*frame(1).movedMm, 6.0 / 34, 1e-3) << "one of 34 joints by 6 mm";
    make(core::acceptProposalsEdit(set, cameras, 2, kRater));
    ASSERT_TRUE(frame(2).movedMm);
    EXPECT_NEAR(*frame(2).movedMm, 0, 1e-6);
    EXPECT_NEAR(frame(2).doubt, 0.05, 1e-9) << "what is expected of others follows from it";
    EXPECT_FALSE(frame(0).isReviewed);
}

TEST_F(ProposalReviewTest, UndoOfAnAcceptedFrameBringsItBackAndUndoOfTheProposalsTakesItAway) {
    const core::Edit first = core::proposeEdit(set, cameras, 0, kRater, hand(Side::Left, 0));
    make(first);
    const core::Edit accepted = core::acceptProposalsEdit(set, cameras, 0, kRater);
    make(accepted);
    EXPECT_TRUE(frame(0).isReviewed);
    make(core::inverse(accepted));
    EXPECT_FALSE(frame(0).isReviewed);
    EXPECT_NEAR(frame(0).doubt, 0.5, 1e-9) << "no likelihood was given";
    make(core::inverse(first));
    EXPECT_TRUE(review.frames().empty());
}

TEST_F(ProposalReviewTest, AcceptedProposalsKeepTheirPlaceAndClickedJointsGetTheirReprojection) {
    propose(0, hand(Side::Left, 0), 0.3);
    const auto joints = hand(Side::Left, 0);
    const Eigen::Vector3d moved = joints[1].pointInWorld + Eigen::Vector3d(0, 8, 0);
    click(0, joints[1].joint, moved, 2);
    const core::MarkKey accepted{0, kRater, joints[4].joint, "cam5"}, clicked{0, kRater, joints[1].joint, "cam5"};
    const core::Mark before = *core::markAt(set, accepted);
    make(core::acceptProposalsEdit(set, cameras, 0, kRater));
    const core::Mark after = *core::markAt(set, accepted);
    EXPECT_EQ(after.placement, core::Placement::Auto);
    EXPECT_EQ(after.px, before.px);
    EXPECT_EQ(after.likelihood, before.likelihood);
    EXPECT_NEAR((core::markAt(set, clicked)->px - *core::project(cameras[5], moved)).norm(), 0, 0.05);
    for (const auto& [key, mark] : set.marks)
        EXPECT_FALSE(mark.isProposal());
    EXPECT_TRUE(core::acceptProposalsEdit(set, cameras, 0, kRater).empty());
}

} // namespace
