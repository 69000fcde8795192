// SPDX-License-Identifier: MIT
#include "core/annotation/raters.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/clicks.h"

namespace {

using core::AnnotationSet;
using core::JointId;
using core::Side;
using Eigen::Vector3d;

const JointId kLeftWrist{Side::Left, "wrist"}, kTip{Side::Right, "index_tip"};

class Raters : public testing::Test {
protected:
    Vector3d place(int frame) { return {0.5 * frame - 40, 20 - 0.3 * frame, 5}; }
    void click(const std::string& rater, const JointId& joint, int frames, double sigmaPx,
               const Vector3d& shift = Vector3d(0, 0, 0)) {
        for (int frame = 0; frame < frames; ++frame)
            test::clickEverywhere(m_set, m_cameras, frame, rater, joint, place(frame) + shift, sigmaPx, &m_random);
    }

    std::vector<core::Camera> m_cameras = test::cameraRing(8);
    AnnotationSet m_set;
    std::mt19937_64 m_random = test::randomFor("Raters");
};

TEST_F(Raters, BiasOfOneRaterIsFoundPerAxisAndJoint) {
    click("ann", kLeftWrist, 50, 0);
    click("bob", kLeftWrist, 40, 0, {2, 0, -1});
    click("ann", kTip, 30, 0);
    click("bob", kTip, 30, 0);
    const auto comparison = core::compareRaters(m_set, m_cameras, "ann", "bob");
    ASSERT_TRUE(comparison);
    EXPECT_EQ(comparison->all.count, 70);
    const core::Agreement& wrist = comparison->byJoint.at(kLeftWrist);
    EXPECT_EQ(wrist.count, 40);
    EXPECT_NEAR(wrist.meanMm, std::sqrt(5.0), 1e-6);
    EXPECT_NEAR(wrist.axes[0].biasMm, -2, 1e-6);
    EXPECT_NEAR(wrist.axes[2].biasMm, 1, 1e-6);
    EXPECT_NEAR(wrist.axes[0].sdMm, 0, 1e-6);
    EXPECT_NEAR(comparison->byJoint.at(kTip).meanMm, 0, 1e-6);
    EXPECT_NEAR(comparison->all.medianMm, std::sqrt(5.0), 1e-6);
}

TEST_F(Raters, LimitsOfAgreementHold95PercentOfTheDifferences) {
    click("ann", kLeftWrist, 400, 1.0);
    click("bob", kLeftWrist, 400, 1.0);
    const auto comparison = core::compareRaters(m_set, m_cameras, "ann", "bob");
    const auto first = core::sequencePoints(m_set, m_cameras, "ann"),
               second = core::sequencePoints(m_set, m_cameras, "bob");
    for (int axis = 0; axis < 3; ++axis) {
        const core::BlandAltman& numbers = comparison->all.axes[axis];
        int inside = 0;
        for (const auto& [frame, joints] : first) {
            const double difference =
                (joints.at(kLeftWrist).pointInWorld - second.at(frame).at(kLeftWrist).pointInWorld)[axis];
            inside += difference > numbers.lowerMm() && difference < numbers.upperMm();
        }
        EXPECT_NEAR(inside / 400.0, 0.95, 0.03);
        EXPECT_LT(std::abs(numbers.biasMm), 4 * numbers.sdMm / 20); // four standard errors
    }
    EXPECT_NEAR(comparison->clickSigmaPx(), 1.0, 0.03); // what was put in
}

TEST_F(Raters, OnlyThoseWhoShareSomethingAreCompared) {
    click("ann", kLeftWrist, 10, 0);
    click("bob", kLeftWrist, 5, 0);
    click("eve", kTip, 5, 0);
    const auto all = core::compareAllRaters(m_set, m_cameras);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].first, "ann");
    EXPECT_EQ(all[0].second, "bob");
    EXPECT_FALSE(core::compareRaters(m_set, m_cameras, "ann", "eve"));
}

TEST_F(Raters, ConsensusIsBetterThanEitherAndTrustsTheSteadierOne) {
    click("ann", kLeftWrist, 200, 0.5);
    click("bob", kLeftWrist, 200, 3.0);
    core::ClickSigmas sigmas;
    sigmas.raters["ann"] = {0.5, std::vector<double>(8, 0.5), 1600, 0, false};
    sigmas.raters["bob"] = {3.0, std::vector<double>(8, 3.0), 1600, 0, false};
    double weighted = 0, equal = 0, steady = 0;
    core::TriangulationOptions wide;
    wide.sigmaPx = 3;
    for (int frame = 0; frame < 200; ++frame) {
        const auto error = [&](const core::TriangulationResult& result) {
            return (result.point->pointInWorld - place(frame)).squaredNorm();
        };
        weighted += error(core::consensus(m_set, m_cameras, frame, kLeftWrist, sigmas).result);
        equal += error(core::consensus(m_set, m_cameras, frame, kLeftWrist, {}, wide).result);
        steady += error(core::reconstruct(m_set, m_cameras, frame, "ann", kLeftWrist).result);
    }
    EXPECT_LT(weighted, equal);
    EXPECT_LT(weighted, 1.02 * steady);
}

TEST_F(Raters, ConsensusNamesTheRaterWhoIsWrong) {
    for (const char* rater : {"ann", "bob", "eve"})
        click(rater, kLeftWrist, 1, 0.5);
    m_set.marks.at({0, "bob", kLeftWrist, "cam2"}).px.x() += 50;
    const auto result = core::consensus(m_set, m_cameras, 0, kLeftWrist);
    ASSERT_EQ(result.clicks.size(), 24u);
    for (const core::ConsensusClick& click : result.clicks)
        EXPECT_EQ(click.outlier, click.rater == "bob" && click.camera == "cam2");
}

TEST_F(Raters, ConsensusDoesNotAverageOutWhatAllRatersShare) {
    for (const char* rater : {"ann", "bob"})
        click(rater, kLeftWrist, 1, 0.5);
    core::ClickSigmas sigmas;
    for (const char* rater : {"ann", "bob"})
        sigmas.raters[rater] = {1.0, std::vector<double>(8, 1.0), 1600, 0, false};
    const auto variance = [&] {
        return core::consensus(m_set, m_cameras, 0, kLeftWrist, sigmas).result.point->covariance.trace();
    };
    const double ofHands = variance();
    sigmas.systematicPx.assign(8, 2.0);
    // sigma^2 of a view: 1 / 2 of the hands alone, 1 / 2 + 4 with the calibration's.
    EXPECT_NEAR(variance() / ofHands, 4.5 / 0.5, 1e-6);
}

TEST_F(Raters, RepeatTasksAreASubsetOfWhatIsFinishedDrawnBySeed) {
    click("ann", kLeftWrist, 60, 0.5);
    m_set.marks[{70, "ann", kTip, "cam0"}] = core::Mark{{5, 5}}; // one view: not finished
    const auto tasks = core::drawRepeatTasks(m_set, m_cameras, "ann", 0.2, 7);
    EXPECT_EQ(tasks.size(), 12u);
    EXPECT_EQ(std::set<core::RepeatTask>(tasks.begin(), tasks.end()).size(), 12u);
    for (const core::RepeatTask& task : tasks)
        EXPECT_TRUE(task.joint == kLeftWrist && task.frame < 60);
    EXPECT_EQ(core::drawRepeatTasks(m_set, m_cameras, "ann", 0.2, 7), tasks);
    EXPECT_NE(core::drawRepeatTasks(m_set, m_cameras, "ann", 0.2, 8), tasks);
    EXPECT_EQ(core::drawRepeatTasks(m_set, m_cameras, "ann", 0.0, 7).size(), 1u);
    EXPECT_TRUE(core::drawRepeatTasks(m_set, m_cameras, "nobody", 0.5, 7).empty());
}

TEST_F(Raters, IntraRaterErrorIsTheComparisonWithTheRepeat) {
    click("ann", kLeftWrist, 100, 0.8);
    click(core::repeatRaterName("ann"), kLeftWrist, 100, 0.8);
    EXPECT_TRUE(core::isRepeatRater(core::repeatRaterName("ann")));
    EXPECT_FALSE(core::isRepeatRater("ann"));
    const auto comparison = core::compareRaters(m_set, m_cameras, "ann", core::repeatRaterName("ann"));
    EXPECT_NEAR(comparison->clickSigmaPx(), 0.8, 0.04);
    EXPECT_LT(comparison->all.meanMm, 1.0);
}

TEST(RaterWork, CountsSettledMarksAndTheirFrames) {
    core::AnnotationSet set;
    const core::JointId joint{core::Side::Left, "wrist"};
    for (const int frame : {3, 4}) {
        for (const char* camera : {"cam0", "cam1"})
            set.marks[{frame, "anna", joint, camera}] = core::Mark{{1, 2}};
        set.marks[{frame, "net", joint, "cam0"}] = {{1, 2}, core::Placement::Proposed, core::MarkState::Visible};
    }
    set.marks[{4, "bob", joint, "cam0"}] = core::Mark{{1, 2}};
    EXPECT_EQ(core::raterWork(set), (std::vector<core::RaterWork>{{"anna", 4, 2}, {"bob", 1, 1}}));
}

} // namespace
