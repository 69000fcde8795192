// SPDX-License-Identifier: MIT
#include "widgets/jobs/quality_checks.h"

#include <gtest/gtest.h>

#include "core/rig/click_sigma_estimate.h"
#include "tests/support/recordings/five_finger_dataset.h"
#include "tests/support/wait_until.h"

namespace {

using core::JointId;
using core::Side;

class QualityChecksTest : public testing::Test {
protected:
    QualityChecksTest() {
        document.setRater("ann");
        document.open({});
        checks.setDataset(dataset);
        for (int frame = 0; frame <= 40; frame += 10)
            mark(frame, "ann", test::fiveFingerJoints(*dataset, 0.2 + 0.005 * frame));
        settle();
    }
    void mark(int frame, const std::string& rater, const std::map<JointId, Eigen::Vector3d>& joints) {
        document.push(core::importEdit(
            document.annotations(),
            [&] {
                core::AnnotationSet set;
                for (const auto& [joint, point] : joints)
                    test::clickEverywhere(set, dataset->cameras, frame, rater, joint, point, 0.4, &random);
                return set;
            }(),
            "import"));
    }
    core::ClickSigmas estimated() const {
        std::vector<core::RigJoint> joints;
        core::addRigJoints(joints, document.annotations(), dataset->cameras, 0);
        return core::estimateClickSigmas(dataset->cameras, joints);
    }
    void settle() {
        ASSERT_TRUE(test::waitUntil([this] { return checks.isUpToDate(); }));
    }

    std::mt19937_64 random = test::randomFor("quality checks");
    std::shared_ptr<const core::Dataset> dataset = test::fiveFingerDataset();
    widgets::JobPool pool;
    widgets::AnnotationDocument document;
    widgets::QualityChecks checks{document, pool};
};

TEST_F(QualityChecksTest, FindNothingInGoodHands) {
    EXPECT_TRUE(checks.findings().empty()) << checks.findings().front().text;
}

TEST_F(QualityChecksTest, LookAgainWhenClicksCountOtherwise) {
    core::AnnotationSet set = document.annotations();
    core::MarkKey key{20, "ann", {Side::Left, "ring_dip"}, dataset->cameras[2].name};
    core::Mark moved = set.marks.at(key);
    moved.px.x() += 5;       // within the gate of assumed sigmas, far beyond that of a hand this steady
    core::AnnotationSet one; // an import replaces all views of a joint
    for (const core::Camera& camera : dataset->cameras)
        one.marks[{20, "ann", key.joint, camera.name}] = set.marks.at({20, "ann", key.joint, camera.name});
    one.marks[key] = moved;
    document.push(core::importEdit(document.annotations(), one, "moved"));
    settle();
    EXPECT_TRUE(checks.findings().empty()) << checks.findings().front().text;
    checks.setClickSigmas(estimated());
    settle();
    ASSERT_EQ(checks.findings().size(), 1u);
    EXPECT_EQ(checks.findings().front().camera, key.camera);
    EXPECT_EQ(checks.findings().front().kind, core::QualityKind::Disagreement);
}

TEST_F(QualityChecksTest, FollowEditsAndUndo) {
    auto joints = test::fiveFingerJoints(*dataset, 0.3);
    const JointId tip{Side::Left, "ring_tip"}, dip{Side::Left, "ring_dip"};
    joints[tip] = joints[dip] + 1.4 * (joints[tip] - joints[dip]);
    mark(20, "ann", {{tip, joints[tip]}});
    settle();
    ASSERT_FALSE(checks.findings().empty());
    core::QualityOptions options;
    options.triangulation = core::ClickSigmas{}.optionsFor("ann");
    EXPECT_EQ(checks.findings(),
              core::checkSequence(document.annotations(), dataset->cameras, "ann", dataset->hands, options));
    EXPECT_EQ(checks.findings().front().frame, 20);
    document.undoStack()->undo();
    settle();
    EXPECT_TRUE(checks.findings().empty());
}

TEST_F(QualityChecksTest, CoverTheCurrentRaterOnly) {
    auto joints = test::fiveFingerJoints(*dataset, 0.3);
    std::swap(joints[{Side::Left, "index_mcp"}], joints[{Side::Left, "ring_mcp"}]);
    mark(20, "bob", joints);
    settle();
    EXPECT_TRUE(checks.findings().empty());
    document.setRater("bob");
    settle();
    ASSERT_FALSE(checks.findings().empty());
    EXPECT_EQ(checks.findings().front().kind, core::QualityKind::FingerOrder);
}

} // namespace
