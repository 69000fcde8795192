// SPDX-License-Identifier: MIT
#include "widgets/jobs/hand_model_fit.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/recordings/five_finger_dataset.h"
#include "tests/support/wait_until.h"

namespace {

using core::JointId;
using core::Side;

class ModelOfMarksTest : public testing::Test {
protected:
    ModelOfMarksTest() {
        document.open({});
        selection.setFrameCount(10);
        reconstructions.setDataset(dataset);
        model.setDataset(dataset);
    }
    /// Marks the joints of the left hand, but for the tips.
    void markLeft() {
        auto joints = truth;
        std::erase_if(joints, [](const auto& entry) {
            return entry.first.hand == Side::Right || entry.first.joint.ends_with("_tip");
        });
        document.push(test::clicksEdit(*dataset, 0, document.rater(), joints));
    }

    std::shared_ptr<const core::Dataset> dataset = test::fiveFingerDataset();
    std::map<JointId, Eigen::Vector3d> truth = test::fiveFingerJoints(*dataset, 0.4);
    widgets::JobPool pool;
    widgets::Selection selection;
    widgets::AnnotationDocument document;
    widgets::Reconstructions reconstructions{document, selection};
    widgets::HandModelFit model{document, selection, reconstructions, pool};
};

TEST_F(ModelOfMarksTest, ProposesTheJointsThatAreMissing) {
    markLeft();
    QSignalSpy fitted(&model, &widgets::HandModelFit::fitted);
    std::optional<widgets::ModelFit> fit;
    QObject::connect(&model, &widgets::HandModelFit::fitted, [&](const widgets::ModelFit& found) { fit = found; });
    model.fitOnce();
    ASSERT_TRUE(test::waitUntil([&] { return fit.has_value(); }));
    EXPECT_LT(fit->rmsMm, 0.3);
    ASSERT_EQ(fit->poses.size(), 2u);
    EXPECT_GT(fit->poses[0].size(), 0);
    EXPECT_EQ(fit->poses[1].size(), 0) << "the right hand has no marks";
    ASSERT_EQ(fit->proposals.size(), 5u);
    for (const core::JointPoint& proposal : fit->proposals) {
        EXPECT_TRUE(proposal.joint.joint.ends_with("_tip"));
        EXPECT_LT((proposal.pointInWorld - truth.at(proposal.joint)).norm(), 12)
            << proposal.joint.joint; // a tip's angle is a guess
    }
}

TEST_F(ModelOfMarksTest, SaysWhatItNeeds) {
    QSignalSpy impossible(&model, &widgets::HandModelFit::impossible);
    model.fitOnce();
    ASSERT_TRUE(test::waitUntil([&] { return impossible.count() == 1; }));
    EXPECT_TRUE(impossible[0][0].toString().contains(QStringLiteral("three joints")));
    model.setDataset(std::make_shared<const core::Dataset>());
    model.fitOnce();
    EXPECT_EQ(impossible.count(), 2);
}

TEST_F(ModelOfMarksTest, FollowsTheMarksWhileItIsOn) {
    markLeft();
    EXPECT_FALSE(model.fit());
    model.setOn(true);
    ASSERT_TRUE(test::waitUntil([&] { return model.fit().has_value(); }));
    const core::Pose before = model.fit()->poses[0];
    auto moved = truth;
    for (auto& [joint, point] : moved)
        point.x() += 5;
    std::erase_if(moved, [](const auto& entry) { return entry.first.hand == Side::Right; });
    document.push(core::importEdit(
        document.annotations(),
        [&] {
            core::AnnotationSet set;
            for (const auto& [joint, point] : moved)
                test::clickEverywhere(set, dataset->cameras, 0, document.rater(), joint, point);
            return set;
        }(),
        "import"));
    ASSERT_TRUE(test::waitUntil([&] { return model.fit() && (model.fit()->poses[0] - before).norm() > 4; }));
    selection.setFrame(3);
    ASSERT_TRUE(test::waitUntil([&] { return !model.fit(); })) << "nothing is marked there";
    model.setOn(false);
    EXPECT_FALSE(model.fit());
}

} // namespace
