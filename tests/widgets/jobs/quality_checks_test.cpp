// SPDX-License-Identifier: MIT
#include "widgets/jobs/quality_checks.h"

#include <gtest/gtest.h>

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
    void settle() {
        ASSERT_TRUE(test::waitUntil([this] { return checks.isUpToDate(); }));
    }

    std::mt19937_64 random = test::randomFor("quality checks");
    std::shared_ptr<const core::Dataset> dataset = test::fiveFingerDataset();
    widgets::JobPool pool;
    widgets::AnnotationDocument document;
    widgets::QualityChecks checks{document, pool};
};

TEST_F(QualityChecksTest, FindNothingInGoodHandsAndKnowTheClickNoise) {
    EXPECT_TRUE(checks.findings().empty()) << checks.findings().front().text;
    ASSERT_TRUE(checks.clickNoise());
    EXPECT_NEAR(checks.clickNoise()->sigmaPx, 0.4, 0.04);
}

TEST_F(QualityChecksTest, KnowWhatTheClicksAreWorth) {
    const core::RaterSigma& sigma = checks.clickSigmas().of("ann");
    EXPECT_FALSE(sigma.isAssumed);
    EXPECT_NEAR(sigma.clickPx, 0.4, 0.04);
    EXPECT_EQ(sigma.clickPxByCamera.size(), dataset->cameras.size());
    EXPECT_TRUE(checks.clickSigmas().of("bob").isAssumed);
    int changes = 0;
    QObject::connect(&checks, &widgets::QualityChecks::clickSigmasChanged, &checks, [&changes] { ++changes; });
    auto one = test::fiveFingerJoints(*dataset, 0.2);
    mark(50, "bob", {*one.begin()}); // few clicks: nothing is estimated anew
    settle();
    EXPECT_EQ(changes, 0);
    for (int frame = 60; frame <= 90; frame += 10)
        mark(frame, "bob", test::fiveFingerJoints(*dataset, 0.2 + 0.005 * frame));
    settle();
    EXPECT_EQ(changes, 1);
    EXPECT_FALSE(checks.clickSigmas().of("bob").isAssumed);
}

TEST_F(QualityChecksTest, FollowEditsAndUndo) {
    auto joints = test::fiveFingerJoints(*dataset, 0.3);
    const JointId tip{Side::Left, "ring_tip"}, dip{Side::Left, "ring_dip"};
    joints[tip] = joints[dip] + 1.4 * (joints[tip] - joints[dip]);
    mark(20, "ann", {{tip, joints[tip]}});
    settle();
    ASSERT_FALSE(checks.findings().empty());
    core::QualityOptions options;
    options.triangulation = checks.clickSigmas().optionsFor("ann");
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
