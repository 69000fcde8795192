// SPDX-License-Identifier: MIT
// The first pass and the review of its proposals in the real window, with labels that are made up.
#include <atomic>
#include <thread>

#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

#include "tests/app/window_fixture.h"
#include "tests/support/detection/fake_first_pass.h"

namespace {

using core::Side;

class ReviewWindow : public test::WindowTest {
protected:
    ReviewWindow() { session().firstPass.setProgram(test::fakeFirstPass(fake)); }

    widgets::ReviewPanel* panel() { return window->workspaces().reviewPanel(); }
    QString cell(int row, int column) { return panel()->table()->model()->index(row, column).data().toString(); }
    void run() {
        fake->doubts = {{5, 0.6}, {10, 0.9}, {15, 0.6}};
        ASSERT_EQ(play("{\"do\":\"firstPass\",\"first\":0,\"last\":25,\"step\":5}\n"), 0) << errors.str();
    }
    core::Mark markOf(int frame, const core::JointId& joint, const char* camera) {
        return core::markAt(session().document.annotations(), {frame, "ann", joint, camera}).value();
    }

    std::shared_ptr<test::FakeFirstPass> fake = std::make_shared<test::FakeFirstPass>();
    const core::JointId wrist{Side::Left, "wrist"};
};

TEST_F(ReviewWindow, TheFirstPassFillsTheQueueAndTheListOfJointsFollows) {
    run();
    EXPECT_NE(answers.str().find("\"frames\":6"), std::string::npos) << answers.str();
    EXPECT_EQ(session().joints.choice(), widgets::JointChoice::TwentyOne);
    ASSERT_TRUE(panel()->isVisible());
    ASSERT_EQ(panel()->table()->model()->rowCount(), 6);
    EXPECT_EQ(cell(0, widgets::ReviewModel::Frame), QStringLiteral("10"));
    EXPECT_EQ(cell(0, widgets::ReviewModel::Doubt), QStringLiteral("90"));
    EXPECT_EQ(cell(0, widgets::ReviewModel::Neighbours), QStringLiteral("2"));
    EXPECT_EQ(session().document.undoStack()->count(), 1);
    EXPECT_FALSE(panel()->firstPass()->isVisible()) << "it makes room for the queue";
}

TEST_F(ReviewWindow, ThatCamerasAreOffIsSaid) {
    QSignalSpy said(&window->statusLine(), &widgets::StatusLine::said);
    const auto isSaid = [&said] {
        return std::any_of(said.begin(), said.end(), [](const QList<QVariant>& one) {
            return one[0].toString().contains(QStringLiteral("4.3 px beside the hands: refine the calibration"));
        });
    };
    run();
    EXPECT_GT(said.size(), 0);
    EXPECT_FALSE(isSaid()) << "these are right";
    fake->camerasOffPx = 4.31;
    run();
    EXPECT_TRUE(isSaid());
}

TEST_F(ReviewWindow, ViewsShowTheHandsOfTheFrameThatIsLookedAt) {
    widgets::CameraView* view = window->workspaces().grid()->view(0);
    const QRectF corner(2, 2, 12, 12);
    view->setHome(corner); // where no hand is
    run();
    const QRectF found = view->home();
    EXPECT_NE(found, corner);
    view->setHome(corner);
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Shift+W\"}\n"), 0) << errors.str();
    EXPECT_NE(view->home(), corner) << "by a key";
    view->setHome(corner);
    panel()->table()->clicked(panel()->table()->model()->index(1, 0));
    EXPECT_NE(view->home(), corner) << "by a row";
}

TEST_F(ReviewWindow, KeysAcceptAFrameAndGoToTheNext) {
    run();
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Shift+W\"}\n"), 0) << errors.str();
    EXPECT_EQ(session().selection.frame(), 10);
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Shift+E\"}\n"), 0) << errors.str();
    EXPECT_EQ(session().selection.frame(), 5);
    EXPECT_EQ(markOf(10, wrist, "cam0").placement, core::Placement::Auto);
    EXPECT_EQ(panel()->table()->model()->rowCount(), 5);
    EXPECT_TRUE(session().reconstructions.compute(10, wrist).hasPoint());
    EXPECT_TRUE(fake->followed.empty()) << "nothing was corrected";
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Ctrl+Z\"}\n"), 0) << errors.str();
    EXPECT_TRUE(markOf(10, wrist, "cam0").isProposal());
    EXPECT_EQ(panel()->table()->model()->rowCount(), 6);
}

TEST_F(ReviewWindow, ACorrectedFrameIsFollowedToItsNeighbours) {
    run();
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Shift+W\"}\n"
                   "{\"do\":\"key\",\"keys\":\"Shift+C\"}\n"),
              0)
        << errors.str();
    const core::JointId joint = session().selection.joint();
    const widgets::ReviewRow* row = session().review.find(10);
    ASSERT_TRUE(row);
    EXPECT_EQ(joint, row->why.joint);
    const core::Mark before = markOf(10, joint, "cam0");
    for (const char* name : {"cam0", "cam2"}) {
        const core::Mark mark = markOf(10, joint, name);
        session().annotator.place(name, mark.px + Eigen::Vector2d(3, 0));
    }
    EXPECT_EQ(markOf(10, joint, "cam0").px, before.px + Eigen::Vector2d(3, 0));
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Shift+E\"}\n"), 0) << errors.str();
    EXPECT_TRUE(markOf(10, joint, "cam0").isEvidence());
    EXPECT_EQ(markOf(10, joint, "cam5").placement, core::Placement::Auto);
    ASSERT_TRUE(app::waitFor(*window, [this] {
        return !fake->followed.empty() && core::markAt(session().document.annotations(), {11, "ann", wrist, "cam0"});
    }));
    EXPECT_EQ(fake->followed, (std::vector{10}));
}

TEST_F(ReviewWindow, TheStatusLineShowsTheRunAndStopKeepsWhatIsDone) {
    std::atomic<bool> isThere = false, isOpen = false;
    fake->beforeFrame = [&](int frame) {
        isThere = frame == 10;
        while (frame == 10 && !isOpen)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    panel()->firstPass()->setFrames(0, 25, 5);
    window->actions().action(QStringLiteral("firstPass.run"))->trigger();
    ASSERT_TRUE(app::waitFor(*window, [&] { return isThere.load(); }));
    auto* stop = window->statusLine().findChild<QToolButton*>(QStringLiteral("stop"));
    ASSERT_TRUE(app::waitFor(*window, [stop] { return stop->isVisible(); }));
    session().selection.setFrame(3); // the window stays alive
    ASSERT_TRUE(app::waitUntilIdle(*window));
    stop->click();
    isOpen = true;
    ASSERT_TRUE(app::waitFor(*window, [this] { return !session().firstPass.isRunning(); }));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_FALSE(stop->isVisible());
    EXPECT_EQ(panel()->table()->model()->rowCount(), 3);
}

TEST_F(ReviewWindow, WithoutTheDetectorItSaysWhatIsMissingAndTakesAPackage) {
    fake->installed = false;
    ASSERT_EQ(play("{\"do\":\"action\",\"id\":\"annotation.firstPass\"}\n"
                   "{\"do\":\"action\",\"id\":\"firstPass.run\"}\n"),
              0)
        << errors.str();
    EXPECT_TRUE(session().document.annotations().marks.empty());
    const auto* bar = panel()->firstPass()->findChild<widgets::MessageBar*>();
    ASSERT_TRUE(bar && bar->isVisible());
    EXPECT_TRUE(bar->message().contains(QStringLiteral("npm pack @mediapipe/hands"))) << bar->message().toStdString();
    session().firstPass.install(path("hands.tgz"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_TRUE(bar->message().contains(QStringLiteral("1.2.3"))) << bar->message().toStdString();
    run();
    EXPECT_EQ(panel()->table()->model()->rowCount(), 6);
}

TEST_F(ReviewWindow, AnotherSequenceIsOpenedFirst) {
    auto* sequences = panel()->firstPass()->findChild<QComboBox*>();
    sequences->setCurrentText(QStringLiteral("b"));
    panel()->firstPass()->setFrames(0, 4, 2);
    panel()->firstPass()->start();
    ASSERT_TRUE(app::waitFor(*window, [this] { return !session().document.annotations().marks.empty(); }));
    EXPECT_EQ(session().opened.sequence()->name, "b");
    EXPECT_EQ(core::annotatedFrames(session().document.annotations()), (std::vector{0, 2, 4}));
}

TEST_F(ReviewWindow, ClosingTheWindowWhileItRunsKeepsWhatIsDone) {
    std::atomic<bool> isThere = false, isOpen = false;
    fake->beforeFrame = [&](int frame) {
        isThere = frame == 10;
        while (frame == 10 && !isOpen)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    panel()->firstPass()->setFrames(0, 25, 5);
    panel()->firstPass()->start();
    ASSERT_TRUE(app::waitFor(*window, [&] { return isThere.load(); }));
    window->close();
    isOpen = true;
    window.reset();
    EXPECT_TRUE(std::filesystem::exists(dataset() / "annotations/a.sqlite.first-pass"));
    start();
    EXPECT_TRUE(session().document.annotations().marks.empty());
}

} // namespace
