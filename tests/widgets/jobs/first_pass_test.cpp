// SPDX-License-Identifier: MIT
#include "widgets/jobs/first_pass.h"

#include <atomic>
#include <thread>

#include <QElapsedTimer>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "core/io/dataset/dataset_annotations.h"
#include "tests/support/detection/fake_first_pass.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"
#include "tests/support/wait_until.h"

namespace {

using core::Side;

class FirstPassTest : public testing::Test {
protected:
    FirstPassTest() {
        test::writeTinyDataset(folder / "dataset");
        dataset = std::make_shared<const core::Dataset>(core::readDataset(folder / "dataset"));
        document.setRater("ann");
        document.open(widgets::AnnotationDocument::read(core::annotationFile(*dataset, dataset->sequences[0])));
        pass->setSequence(dataset, &dataset->sequences[0]);
        QObject::connect(
            pass.get(), &widgets::FirstPass::finished,
            [this](const widgets::FirstPassResult& result) { finished = result; });
        QObject::connect(pass.get(), &widgets::FirstPass::failed, [this](const QString& text) { failure = text; });
    }
    ~FirstPassTest() override { isOpen = true; }
    bool wait() {
        return test::waitUntil([this] { return !pass->isRunning(); });
    }
    /// The worker waits at that frame until the gate is opened.
    void holdAt(int frame) {
        fake->beforeFrame = [this, frame](int at) {
            if (at != frame)
                return;
            isThere = true;
            while (!isOpen)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
    }
    std::filesystem::path journal() const {
        return core::annotationFile(*dataset, dataset->sequences[0]).string() + ".first-pass";
    }
    std::set<int> framesWithProposals() const {
        std::set<int> frames;
        for (const auto& [key, mark] : document.annotations().marks)
            if (mark.isProposal())
                frames.insert(key.frame);
        return frames;
    }

    test::TemporaryFolder folder;
    std::shared_ptr<const core::Dataset> dataset;
    std::shared_ptr<test::FakeFirstPass> fake = std::make_shared<test::FakeFirstPass>();
    std::atomic<bool> isThere = false, isOpen = false;
    std::optional<widgets::FirstPassResult> finished;
    QString failure;
    std::unique_ptr<widgets::JobPool> pool = std::make_unique<widgets::JobPool>();
    widgets::AnnotationDocument document;
    std::unique_ptr<widgets::FirstPass> pass =
        std::make_unique<widgets::FirstPass>(document, *pool, test::fakeFirstPass(fake));
};

TEST_F(FirstPassTest, ProposesTheJointsOfAllFramesInOneUndoStepWithTheirDoubts) {
    fake->doubts[10] = 0.7;
    pass->run({{0, 5, 10}});
    ASSERT_TRUE(wait());
    ASSERT_TRUE(finished);
    EXPECT_EQ(finished->frames, 3);
    EXPECT_TRUE(finished->isFinished);
    EXPECT_EQ(finished->joints.size(), 42u);
    EXPECT_EQ(framesWithProposals(), (std::set{0, 5, 10}));
    const core::MarkKey key{10, "ann", {Side::Left, "index_tip"}, "cam3"};
    const auto mark = core::markAt(document.annotations(), key);
    ASSERT_TRUE(mark);
    EXPECT_NEAR(mark->likelihood.value(), 0.3, 1e-9);
    const Eigen::Vector3d truth = test::madeUpHand(Side::Left, 10)[8].second;
    EXPECT_EQ(mark->px, *core::project(dataset->cameras[3], truth));
    EXPECT_FALSE(std::filesystem::exists(journal())) << "nothing is left to go on with";
    EXPECT_EQ(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    EXPECT_TRUE(document.annotations().marks.empty());
}

TEST_F(FirstPassTest, LeavesSettledMarksAndWhatAPersonDidMeanwhileAlone) {
    const core::MarkKey before{0, "ann", {Side::Left, "wrist"}, "cam0"},
        meanwhile{5, "ann", {Side::Left, "wrist"}, "cam1"};
    document.push(core::placeEdit(document.annotations(), before, {20, 30}));
    holdAt(5);
    pass->run({{0, 5}});
    ASSERT_TRUE(test::waitUntil([this] { return isThere.load(); }));
    document.push(core::placeEdit(document.annotations(), meanwhile, {40, 50}));
    isOpen = true;
    ASSERT_TRUE(wait());
    ASSERT_TRUE(failure.isEmpty()) << failure.toStdString();
    EXPECT_EQ(core::markAt(document.annotations(), before)->px, Eigen::Vector2d(20, 30));
    EXPECT_EQ(core::markAt(document.annotations(), meanwhile)->px, Eigen::Vector2d(40, 50));
    EXPECT_TRUE(core::markAt(document.annotations(), {5, "ann", {Side::Left, "wrist"}, "cam2"})->isProposal());
}

TEST_F(FirstPassTest, TakesTheHandsAndJointsThatWereAskedFor) {
    widgets::FirstPassRequest request{{0}, {Side::Right}, {{Side::Right, "wrist"}, {Side::Left, "wrist"}}};
    pass->run(request);
    ASSERT_TRUE(wait());
    ASSERT_FALSE(document.annotations().marks.empty());
    for (const auto& [key, mark] : document.annotations().marks)
        EXPECT_EQ(key.joint, (core::JointId{Side::Right, "wrist"}));
}

TEST_F(FirstPassTest, StopKeepsTheFramesThatAreDoneAndTheJournal) {
    holdAt(5);
    pass->run({{0, 5, 10, 15}});
    ASSERT_TRUE(test::waitUntil([this] { return isThere.load(); }));
    pass->stop();
    isOpen = true;
    ASSERT_TRUE(wait());
    ASSERT_TRUE(finished);
    EXPECT_FALSE(finished->isFinished);
    EXPECT_EQ(finished->frames, 2);
    EXPECT_EQ(framesWithProposals(), (std::set{0, 5}));
    EXPECT_TRUE(std::filesystem::exists(journal()));
}

TEST_F(FirstPassTest, ClosingWhileItRunsEndsItCleanlyAndKeepsWhatIsDone) {
    holdAt(5);
    pass->run({{0, 5, 10, 15}});
    ASSERT_TRUE(test::waitUntil([this] { return isThere.load(); }));
    document.close();
    EXPECT_FALSE(pass->isRunning());
    isOpen = true;
    pass.reset();
    pool.reset(); // waits for the worker
    EXPECT_FALSE(finished);
    std::ifstream file(journal());
    std::string line;
    std::vector<std::string> lines;
    while (std::getline(file, line))
        lines.push_back(line);
    EXPECT_EQ(lines, (std::vector<std::string>{"0", "5"}));
    EXPECT_TRUE(
        widgets::AnnotationDocument::read(core::annotationFile(*dataset, dataset->sequences[0])).set.marks.empty());
}

TEST_F(FirstPassTest, SaysWhyItCannotRun) {
    document.close();
    pass->run({{0}});
    EXPECT_TRUE(failure.contains(QStringLiteral("Open a dataset"))) << failure.toStdString();
    EXPECT_FALSE(pass->isRunning());
}

TEST_F(FirstPassTest, InstallsAPackageInTheBackgroundOrSaysWhatIsWrongWithIt) {
    fake->installed = false;
    QSignalSpy installed(pass.get(), &widgets::FirstPass::installed);
    pass->install(QStringLiteral("/nowhere/hands.zip"));
    ASSERT_TRUE(test::waitUntil([this] { return !pass->isInstalling(); }));
    EXPECT_TRUE(failure.contains(QStringLiteral("not a package"))) << failure.toStdString();
    EXPECT_FALSE(pass->isInstalled());
    pass->install(QStringLiteral("/nowhere/hands.tgz"));
    ASSERT_TRUE(test::waitUntil([this] { return !pass->isInstalling(); }));
    ASSERT_EQ(installed.count(), 1);
    EXPECT_TRUE(pass->isInstalled());
}

TEST_F(FirstPassTest, FollowsTheHandsFromACorrectedFrame) {
    pass->run({{0, 1}});
    ASSERT_TRUE(wait());
    pass->followFrom(0);
    const core::MarkKey key{1, "ann", {Side::Left, "wrist"}, "cam0"};
    ASSERT_TRUE(test::waitUntil(
        [&] { return std::abs(core::markAt(document.annotations(), key)->likelihood.value() - 0.99) < 1e-9; }));
    EXPECT_EQ(fake->followed, (std::vector{0}));
    EXPECT_EQ(document.undoStack()->count(), 2);
}

class CorrectedFrame : public FirstPassTest {
protected:
    CorrectedFrame() {
        pass->run({{0, 5}});
        wait();
    }
    core::Mark markOf(const std::string& joint, const char* camera) const {
        return core::markAt(document.annotations(), {5, "ann", {Side::Left, joint}, camera}).value();
    }
    void place(const char* camera) {
        const core::MarkKey key{5, "ann", {Side::Left, "index_pip"}, camera};
        const Eigen::Vector2d to = markOf("index_pip", camera).px + Eigen::Vector2d(9, 0);
        document.push(core::placeEdit(document.annotations(), key, to));
    }
    /// Long enough for what should not happen.
    void pause() {
        QElapsedTimer clock;
        clock.start();
        test::waitUntil([&clock] { return clock.hasExpired(700); });
    }
};

TEST_F(CorrectedFrame, OtherJointsFollowAJointThatIsPlacedInTwoViews) {
    QSignalSpy refitted(pass.get(), &widgets::FirstPass::refitted);
    const core::Mark before = markOf("index_tip", "cam3");
    place("cam0");
    pause();
    EXPECT_TRUE(fake->refitted.empty()) << "one view does not place a joint";
    place("cam2");
    const core::Mark placed = markOf("index_pip", "cam2");
    ASSERT_TRUE(test::waitUntil([&] { return refitted.count() == 1; }));
    EXPECT_EQ(fake->refitted, (std::vector{5}));
    const Eigen::Vector3d expected = test::madeUpHand(Side::Left, 6)[8].second;
    EXPECT_EQ(markOf("index_tip", "cam3").px, *core::project(dataset->cameras[3], expected));
    EXPECT_NE(markOf("index_tip", "cam3").px, before.px);
    EXPECT_TRUE(markOf("index_tip", "cam3").isProposal()) << "a person still looks at it";
    EXPECT_EQ(markOf("index_pip", "cam2"), placed);
    EXPECT_EQ(document.undoStack()->count(), 4) << "the pass, two clicks, and what followed";
    document.undoStack()->undo();
    EXPECT_EQ(markOf("index_tip", "cam3"), before);
}

TEST_F(CorrectedFrame, NothingFollowsWhileAMarkIsDragged) {
    place("cam0");
    place("cam2");
    const core::MarkKey dragged{5, "ann", {Side::Left, "wrist"}, "cam1"};
    document.preview(core::placeEdit(document.annotations(), dragged, {30, 40}));
    pause();
    EXPECT_TRUE(fake->refitted.empty());
    EXPECT_EQ(core::markAt(document.annotations(), dragged)->px, Eigen::Vector2d(30, 40));
    document.clearPreview();
    ASSERT_TRUE(test::waitUntil([this] { return fake->refitted.size() == 1; }));
}

TEST_F(CorrectedFrame, WhatWasUndoneStaysWithinReach) {
    place("cam0");
    place("cam2");
    document.undoStack()->undo();
    document.undoStack()->undo();
    document.undoStack()->redo();
    pause();
    EXPECT_TRUE(fake->refitted.empty());
    EXPECT_TRUE(document.undoStack()->canRedo());
}

TEST_F(CorrectedFrame, AFrameThatIsAcceptedStaysAsItIs) {
    place("cam0");
    place("cam2");
    pass->followFrom(5);
    ASSERT_TRUE(test::waitUntil([this] { return fake->followed.size() == 1; }));
    pause();
    EXPECT_TRUE(fake->refitted.empty());
}

} // namespace
