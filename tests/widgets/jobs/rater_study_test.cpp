// SPDX-License-Identifier: MIT
#include "widgets/jobs/rater_study.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/recordings/five_finger_dataset.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace {

class RaterStudyTest : public testing::Test {
protected:
    RaterStudyTest() {
        open();
        selection.setFrameCount(50);
        study.setDataset(dataset);
        for (const int frame : {10, 20, 30})
            mark(frame, "ann", 0.5);
    }
    void open() {
        document.setRater("ann");
        document.open(widgets::AnnotationDocument::read(folder / "a.sqlite"));
    }
    void mark(int frame, const std::string& rater, double sigmaPx) {
        core::AnnotationSet set;
        for (const auto& [joint, point] : test::fiveFingerJoints(*dataset, 0.01 * frame))
            test::clickEverywhere(set, dataset->cameras, frame, rater, joint, point, sigmaPx, &random);
        document.push(core::importEdit(document.annotations(), set, ""));
    }
    /// Waits until the repeat round has begun.
    void begin(double share, unsigned seed) {
        study.beginRepeating(share, seed);
        ASSERT_TRUE(test::waitUntil([&] { return study.isRepeating(); }));
    }
    void compare() {
        QSignalSpy compared(&study, &widgets::RaterStudy::compared);
        study.compare();
        ASSERT_TRUE(test::waitUntil([&] { return compared.count() > 0; }));
    }

    test::TemporaryFolder folder;
    std::mt19937_64 random = test::randomFor("rater study");
    std::shared_ptr<const core::Dataset> dataset = test::fiveFingerDataset();
    widgets::JobPool pool;
    widgets::Selection selection;
    widgets::AnnotationDocument document;
    widgets::RaterStudy study{document, selection, pool};
};

TEST_F(RaterStudyTest, ComparesRatersAndWeighsTheirClicks) {
    mark(20, "bob", 2);
    compare();
    ASSERT_EQ(study.comparisons().size(), 1u);
    EXPECT_EQ(study.comparisons()[0].first, "ann");
    EXPECT_EQ(study.comparisons()[0].second, "bob");
    EXPECT_GT(study.comparisons()[0].all.meanMm, 0.05);
    core::ClickSigmas sigmas;
    sigmas.raters["ann"] = {0.5, std::vector<double>(dataset->cameras.size(), 0.5), 100, 0, false};
    sigmas.raters["bob"] = {2.0, std::vector<double>(dataset->cameras.size(), 2.0), 100, 0, false};
    QSignalSpy compared(&study, &widgets::RaterStudy::compared);
    study.setClickSigmas(sigmas);
    ASSERT_TRUE(test::waitUntil([&] { return compared.count() > 0; })) << "compared again";
    selection.setFrame(20);
    selection.setJoint({core::Side::Right, "middle_pip"});
    const core::Consensus both = study.consensus();
    ASSERT_TRUE(both.result.point);
    EXPECT_GT(both.clicks.size(), 8u);
    const auto truth = test::fiveFingerJoints(*dataset, 0.2).at(selection.joint());
    EXPECT_LT((both.result.point->pointInWorld - truth).norm(), 0.6);
}

TEST_F(RaterStudyTest, ARepeatRoundHidesTheFirstAndGoesOnAfterARestart) {
    const auto finished = document.annotations().marks.size();
    begin(0.1, 4);
    ASSERT_TRUE(study.isRepeating());
    EXPECT_EQ(document.rater(), core::repeatRaterName("ann"));
    const int tasks = study.tasks();
    EXPECT_NEAR(tasks, 0.1 * 3 * static_cast<double>(test::fiveFingerJoints(*dataset, 0.1).size()), 1.01);
    EXPECT_EQ(study.openTasks(), tasks);
    const core::JointId first = selection.joint();
    core::AnnotationSet again;
    test::clickEverywhere(again, dataset->cameras, selection.frame(), document.rater(), first,
                          test::fiveFingerJoints(*dataset, 0.01 * selection.frame()).at(first), 0.5, &random);
    document.push(core::importEdit(document.annotations(), again, "again"));
    EXPECT_EQ(study.openTasks(), tasks - 1);
    EXPECT_TRUE(study.goToNextTask());
    study.endRepeating();
    EXPECT_EQ(document.rater(), "ann");
    ASSERT_TRUE(test::waitUntil([&] { return study.comparisons().size() == 1; }));
    EXPECT_EQ(study.comparisons()[0].all.count, 1);

    document.close();
    open();
    begin(0.5, 99);
    EXPECT_EQ(study.tasks(), tasks) << "the unfinished round goes on";
    EXPECT_EQ(study.openTasks(), tasks - 1);
    EXPECT_GT(document.annotations().marks.size(), finished);
}

TEST_F(RaterStudyTest, NothingFinishedIsNothingToRepeat) {
    document.setRater("new");
    QSignalSpy nothing(&study, &widgets::RaterStudy::nothingToRepeat);
    study.beginRepeating(0.1, 4);
    ASSERT_TRUE(test::waitUntil([&] { return nothing.count() > 0; }));
    EXPECT_FALSE(study.goToNextTask());
    EXPECT_EQ(document.rater(), "new");
}

TEST_F(RaterStudyTest, ARepeatRoundIsBlindAndStaysInItsSequence) {
    begin(0.1, 4);
    study.compare();
    EXPECT_FALSE(study.consensus().result.point) << "it would show how far the second marks are from the first";
    EXPECT_FALSE(test::waitUntil([&] { return !study.comparisons().empty(); }, 200));
    document.open(widgets::AnnotationDocument::read(folder / "b.sqlite"));
    EXPECT_FALSE(study.isRepeating());
    EXPECT_EQ(document.rater(), "ann");
    EXPECT_TRUE(study.comparisons().empty());
}

TEST_F(RaterStudyTest, WhatWasRepeatedIsNotDrawnAgain) {
    begin(1, 4);
    const int all = study.tasks();
    core::AnnotationSet again;
    for (const auto& [key, mark] : document.annotations().marks) {
        core::MarkKey repeated = key;
        repeated.rater = document.rater();
        again.marks[repeated] = mark;
    }
    document.push(core::importEdit(document.annotations(), again, "again"));
    EXPECT_EQ(study.openTasks(), 0);
    EXPECT_GT(all, 0);
    study.endRepeating();
    QSignalSpy nothing(&study, &widgets::RaterStudy::nothingToRepeat);
    study.beginRepeating(1, 5);
    EXPECT_TRUE(test::waitUntil([&] { return nothing.count() > 0; }));
    EXPECT_FALSE(study.isRepeating());
}

} // namespace
