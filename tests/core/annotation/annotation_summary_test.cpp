// SPDX-License-Identifier: MIT
#include "core/annotation/annotation_summary.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"

namespace {

using core::JointId;
using core::Side;

using test::kIndex;

const JointId kThumb{Side::Right, "thumb_ip"};

class AnnotationSummaryTest : public testing::Test {
protected:
    AnnotationSummaryTest() {
        for (int frame = 0; frame < 40; frame += 4) {
            test::clickEverywhere(set, cameras, frame, "ann", kIndex, {10.0 + frame, 5, 0}, 0.7, &random);
            test::clickEverywhere(set, cameras, frame, "bob", kIndex, {10.0 + frame, 5, 0}, 0.7, &random);
        }
        for (const char* camera : {"cam0", "cam1"}) // two views only: less certain
            set.marks[{8, "ann", kThumb, camera}] = {
                *core::project(*std::find_if(cameras.begin(), cameras.end(),
                                             [&](const core::Camera& c) { return c.name == camera; }),
                               {0, 30, 10}),
                core::Placement::Manual, core::MarkState::Visible};
        set.marks[{8, "ann", kThumb, "cam2"}] = {{500, 900}, core::Placement::Auto, core::MarkState::Visible};
    }
    std::vector<core::Camera> cameras = test::cameraRing(6);
    std::mt19937_64 random = test::randomFor("annotation summary");
    core::AnnotationSet set;
};

TEST_F(AnnotationSummaryTest, CountsWhatEachRaterDid) {
    const core::AnnotationSummary summary = core::summariseAnnotations("one", 40, set, cameras, {});
    ASSERT_EQ(summary.raters.size(), 2u);
    const core::RaterSummary& ann = summary.raters[0];
    EXPECT_EQ(ann.rater, "ann");
    EXPECT_EQ(ann.frames, 10);
    EXPECT_EQ(ann.clicks, 10 * 6 + 2);
    EXPECT_EQ(ann.accepted, 1);
    EXPECT_EQ(ann.joints.done, 10);
    EXPECT_EQ(ann.joints.partial, 1);
    EXPECT_EQ(ann.doneByFrame.at(8), 1);
    EXPECT_FALSE(ann.sigma) << "nobody estimated it";
    EXPECT_EQ(summary.raters[1].clicks, 60);
}

TEST_F(AnnotationSummaryTest, TheMostUncertainJointComesFirst) {
    const core::AnnotationSummary summary = core::summariseAnnotations("one", 40, set, cameras, {});
    ASSERT_EQ(summary.joints.size(), 2u);
    EXPECT_EQ(summary.joints[0].joint, kThumb);
    EXPECT_EQ(summary.joints[0].points, 1);
    EXPECT_EQ(summary.joints[1].points, 20);
    EXPECT_GT(summary.joints[0].meanSigmaMm, summary.joints[1].meanSigmaMm);
    EXPECT_EQ(summary.rmsPx.size(), 21u);
    EXPECT_EQ(summary.sigmaMm.size(), 21u);
    ASSERT_EQ(summary.agreement.size(), 1u);
    EXPECT_EQ(summary.agreement[0].all.count, 10);
}

TEST_F(AnnotationSummaryTest, ProposalsCountForNothing) {
    const core::AnnotationSummary before = core::summariseAnnotations("one", 40, set, cameras, {});
    for (const char* const rater : {"ann", "import"}) {
        for (const core::Camera& camera : cameras) {
            set.marks[{9, rater, kIndex, camera.name}] = {
                {500, 900}, core::Placement::Proposed, core::MarkState::Visible};
        }
    }
    const core::AnnotationSummary after = core::summariseAnnotations("one", 40, set, cameras, {});
    ASSERT_EQ(after.raters.size(), 2u);
    EXPECT_EQ(after.raters[0].frames, before.raters[0].frames);
    EXPECT_EQ(after.raters[0].joints, before.raters[0].joints);
    EXPECT_EQ(after.raters[0].findings, before.raters[0].findings);
    EXPECT_EQ(after.joints.size(), before.joints.size());
}

TEST_F(AnnotationSummaryTest, SequencesWithoutMarksHaveNoSummaryAndNoPoints) {
    EXPECT_TRUE(core::summariseAnnotations("none", 40, {}, cameras, {}).empty());
    EXPECT_EQ(core::meanJointPoints(set, cameras, 8).size(), 2u);
    EXPECT_LT((core::meanJointPoints(set, cameras, 8).at(kIndex) - Eigen::Vector3d(18, 5, 0)).norm(), 1);
    EXPECT_TRUE(core::meanJointPoints(set, cameras, 9).empty());
}

} // namespace
