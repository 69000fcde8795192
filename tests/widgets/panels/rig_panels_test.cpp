// SPDX-License-Identifier: MIT
// What the window shows of the calibration and its refinement. Simulated clicks of a rig whose cam5 was turned after it
// was calibrated.
#include <QListWidget>
#include <QTableView>

#include "core/annotation/import_edit.h"
#include "core/geometry/rigid_motion.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/files/text_file.h"
#include "core/io/store/annotation_store.h"
#include "tests/support/clicks.h"
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/models/refinement_model.h"
#include "widgets/models/rig_health_model.h"
#include "widgets/panels/quality/quality_panel.h"
#include "widgets/panels/quality/refinement_page.h"
#include "widgets/presenters/residual_arrows.h"
#include "widgets/text/rig_text.h"

namespace {

constexpr int kMoved = 5;
constexpr double kTurnDeg = 1.2;

class RigPanelTest : public test::PanelTest {
protected:
    RigPanelTest() {
        panel.resize(340, 500);
        panel.show();
        seen = session.opened.dataset()->cameras;
    }
    void turnCamera() {
        core::RigidMotion& motion = seen[kMoved].cameraFromWorld;
        const Eigen::Vector3d centre = seen[kMoved].centreInWorld();
        motion.rotation =
            core::rotationExp(Eigen::Vector3d(0, kTurnDeg * M_PI / 180, 0)) * motion.rotation; // along x in the picture
        motion.translation = -(motion.rotation * centre);
    }
    core::AnnotationSet clicksOf(const std::vector<int>& frames, int joints = 14) {
        auto random = test::randomFor("RigPanels");
        std::uniform_real_distribution<double> uniform(-60, 60);
        core::AnnotationSet set;
        for (const int frame : frames)
            for (int j = 0; j < joints; ++j)
                test::clickEverywhere(set, seen, frame, "ann", {core::Side::Left, "joint" + std::to_string(j)},
                                      {uniform(random), uniform(random), uniform(random)}, 0.3, &random);
        return set;
    }
    void clickFrames(const std::vector<int>& frames, int joints = 14) {
        session.document.push(core::importEdit(session.document.annotations(), clicksOf(frames, joints), "clicks"));
        look();
    }
    void look() {
        ASSERT_TRUE(test::waitUntil([this] { return session.isIdle() && session.rig.isUpToDate(); }));
        settle();
    }
    QTableView& cameraTable() { return *child<QTableView>(*panel.cameras()); }
    /// In how many labels that can be seen.
    std::ptrdiff_t times(QWidget& widget, const char* words) const {
        const auto labels = widget.findChildren<QLabel*>();
        return std::count_if(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisibleTo(&widget) && label->text().contains(QString::fromUtf8(words));
        });
    }
    bool says(QWidget& widget, const char* words) const { return times(widget, words) > 0; }
    static QPushButton* button(QWidget& widget, const char* text) {
        for (QPushButton* one : widget.findChildren<QPushButton*>())
            if (one->text() == QLatin1String(text))
                return one;
        return nullptr;
    }
    QString camerasFile() const { return session.calibrations.inUse(); }

    std::vector<core::Camera> seen; ///< as they were
    widgets::QualityPanel panel{{session.document, session.selection, session.reconstructions, session.joints,
                                 session.coverage, session.checks, session.raters, session.rig}};
};

TEST_F(RigPanelTest, ACameraThatMovedIsNamedOnceAndInTheTable) {
    turnCamera();
    clickFrames({2, 8, 14, 20, 26});
    EXPECT_TRUE(says(panel, "cam5 is")) << "whatever the panel shows";
    QTest::mouseClick(button(panel, "Cameras"), Qt::LeftButton);
    const QTableView& table = cameraTable();
    ASSERT_TRUE(table.isVisible());
    ASSERT_EQ(table.model()->rowCount(), 8);
    for (int row = 0; row < 8; ++row)
        EXPECT_EQ(cell(table, row, widgets::RigHealthModel::State),
                  row == kMoved ? QStringLiteral("off") : QStringLiteral("fits"));
    EXPECT_EQ(cell(table, kMoved, widgets::RigHealthModel::Clicks), QStringLiteral("70"));
    const Eigen::Vector2d shift = *core::project(seen[kMoved], Eigen::Vector3d::Zero()) -
                                  *core::project(session.opened.dataset()->cameras[kMoved], Eigen::Vector3d::Zero());
    ASSERT_GT(shift.norm(), 5);
    EXPECT_NEAR(QLocale().toDouble(cell(table, kMoved, widgets::RigHealthModel::MeanX)), shift.x(), 0.6);
    EXPECT_NEAR(QLocale().toDouble(cell(table, kMoved, widgets::RigHealthModel::MeanY)), shift.y(), 0.6);
    EXPECT_TRUE(says(*panel.cameras(), "px off in every frame: its calibration moved"));
    EXPECT_TRUE(says(*panel.cameras(), "enough clicks to refine"));
}

TEST_F(RigPanelTest, IsLookedAtAMomentAfterTheLastEdit) {
    turnCamera();
    session.document.push(core::importEdit({}, clicksOf({2, 8, 14}), "clicks"));
    EXPECT_FALSE(session.rig.isUpToDate());
    EXPECT_EQ(session.rig.state()->health.joints, 0) << "not yet";
    look();
    EXPECT_EQ(session.rig.state()->health.joints, 3 * 14);
    session.document.undoStack()->undo();
    look();
    EXPECT_EQ(session.rig.state()->health.joints, 0);
    EXPECT_TRUE(widgets::rigNoticeText(session.rig.state()->health, {"a", "b"}).isEmpty());
}

TEST_F(RigPanelTest, ClicksOfTheOtherSequencesCount) {
    turnCamera();
    {
        const core::Dataset& dataset = *session.opened.dataset();
        auto store = core::AnnotationStore::open(core::annotationFile(dataset, dataset.sequence("b")));
        store.commit(core::importEdit({}, clicksOf({1, 4, 7}), "clicks"), "bob");
    }
    clickFrames({2});
    session.opened.openDataset(QString::fromStdString(session.opened.dataset()->folder.string()), QStringLiteral("a"),
                               12);
    look();
    ASSERT_TRUE(session.rig.state());
    EXPECT_EQ(session.rig.state()->health.joints, 4 * 14);
    EXPECT_EQ(session.rig.state()->health.frames, 4);
}

TEST_F(RigPanelTest, WhatAClickIsWorthIsOneNumberForTheWholeDataset) {
    session.document.setRater("ann");
    clickFrames({2}, 2);
    EXPECT_TRUE(session.rig.clickSigmas().of("ann").isAssumed);
    EXPECT_TRUE(says(panel, "Too few clicks to know how far yours scatter: 1 px is assumed."));
    {
        const core::Dataset& dataset = *session.opened.dataset();
        auto store = core::AnnotationStore::open(core::annotationFile(dataset, dataset.sequence("b")));
        store.commit(core::importEdit({}, clicksOf({1, 4, 7}), "clicks"), "ann");
    }
    session.opened.openDataset(QString::fromStdString(session.opened.dataset()->folder.string()), QStringLiteral("a"),
                               12);
    look();
    session.document.setRater("ann");
    look();
    const core::ClickSigmas& known = session.rig.clickSigmas();
    EXPECT_FALSE(known.of("ann").isAssumed) << "clicks of the other sequence count";
    EXPECT_NEAR(known.of("ann").clickPx, 0.3, 0.05);
    EXPECT_TRUE(core::areAlike(known, core::datasetClickSigmas(*session.opened.dataset()))) << "as exports have it";
    EXPECT_EQ(session.reconstructions.clickSigmas(), known);
    EXPECT_EQ(session.raters.clickSigmas(), known);
    EXPECT_EQ(session.reconstructions.options().sigmaPx, known.of("ann").clickPx);
    EXPECT_TRUE(says(panel, "Your clicks scatter by 0.3"));
}

TEST_F(RigPanelTest, SaysWhatIsMissingWithoutClicks) {
    panel.showCameras();
    look();
    EXPECT_TRUE(says(*panel.cameras(), "cannot be judged"));
    EXPECT_FALSE(cameraTable().isVisible());
    EXPECT_FALSE(button(*panel.cameras(), "Refine calibration...")->isEnabled());
    clickFrames({2}, 3);
    EXPECT_TRUE(says(*panel.cameras(), "from 20 joints on"));
    widgets::RefinementPage page(session.rig, session.calibrations);
    page.show();
    page.refine();
    look();
    EXPECT_EQ(times(page, "from 20 joints on"), 1) << "in the message, not below it as well";
    EXPECT_FALSE(session.rig.proposal());
    EXPECT_TRUE(button(page, "Refine")->isEnabled());
}

TEST_F(RigPanelTest, TwoCamerasAreNotJudgedHoweverManyClicks) {
    core::RigHealth health;
    health.cameras.resize(2);
    for (core::CameraHealth& camera : health.cameras)
        camera.clicks = 250;
    const auto state = [&] {
        widgets::RigHealthModel model;
        model.setHealth(health);
        return model.index(0, widgets::RigHealthModel::State).data().toString();
    };
    EXPECT_EQ(state(), QStringLiteral("not known"));
    health.cameras.emplace_back().clicks = 2;
    EXPECT_EQ(state(), QStringLiteral("too few clicks"));
}

class RefinementPageTest : public RigPanelTest {
protected:
    RefinementPageTest() {
        turnCamera();
        clickFrames({2, 8, 14, 20, 26});
        page.show();
        look();
    }
    void refine() {
        QTest::mouseClick(button(page, "Refine"), Qt::LeftButton);
        ASSERT_TRUE(test::waitUntil([this] { return session.rig.proposal() != nullptr; }));
        look();
    }
    double value(int row, int column) { return QLocale().toDouble(cell(*child<QTableView>(page), row, column)); }

    widgets::RefinementPage page{session.rig, session.calibrations};
};

TEST_F(RefinementPageTest, ShowsBeforeAndAfterOfEveryCamera) {
    EXPECT_FALSE(button(page, "Use the refined calibration")->isEnabled());
    refine();
    ASSERT_EQ(child<QTableView>(page)->model()->rowCount(), 8);
    EXPECT_GT(value(kMoved, widgets::RefinementModel::BeforePx), 4);
    EXPECT_LT(value(kMoved, widgets::RefinementModel::AfterPx), 0.6);
    EXPECT_GT(value(kMoved, widgets::RefinementModel::TurnDeg), kTurnDeg / 2) << "the rest is taken for a shift";
    for (const int other : {0, 1, 2, 3, 4, 6, 7})
        EXPECT_LT(value(other, widgets::RefinementModel::TurnDeg), kTurnDeg / 3);
    EXPECT_EQ(camerasFile(), QStringLiteral("cameras.json")) << "nothing changes before it is used";
    QTest::mouseClick(button(page, "Discard"), Qt::LeftButton);
    EXPECT_FALSE(session.rig.proposal());
}

TEST_F(RefinementPageTest, TheResultIsUsedAsANewFileAndTheOldOneCanBeChosenAgain) {
    const auto set = session.opened.dataset()->folder;
    const std::string oldFile = core::readTextFile(set / "cameras.json");
    const core::AnnotationSet before = session.document.annotations();
    const int steps = session.document.undoStack()->count();
    session.document.undoStack()->undo();
    session.document.undoStack()->redo();
    click(index, 0); // one more step, to be undone below
    look();
    refine();
    QTest::mouseClick(button(page, "Use the refined calibration"), Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([this] { return camerasFile() == QLatin1String("cameras-refined-1.json"); }));
    look();
    EXPECT_EQ(core::readTextFile(set / "cameras.json"), oldFile);
    EXPECT_EQ(core::readDataset(set).camerasFile, "cameras-refined-1.json");
    EXPECT_EQ(session.selection.frame(), 12);
    EXPECT_FALSE(session.rig.state()->health.anyOff());
    EXPECT_FALSE(session.rig.proposal());
    ASSERT_EQ(session.document.undoStack()->count(), steps + 1) << "the history is as it was";
    session.document.undoStack()->undo();
    EXPECT_EQ(session.document.annotations().marks, before.marks);
    QListWidget& files = *child<QListWidget>(page);
    ASSERT_TRUE(test::waitUntil([&] { return files.count() == 2; }));
    const auto old = files.findItems(QStringLiteral("cameras.json"), Qt::MatchExactly);
    ASSERT_EQ(old.size(), 1);
    QTest::mouseClick(files.viewport(), Qt::LeftButton, {}, files.visualItemRect(old.front()).center());
    QTest::mouseClick(button(page, "Use the chosen one"), Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([this] { return camerasFile() == QLatin1String("cameras.json"); }));
    look();
    EXPECT_TRUE(session.rig.state()->health.cameras[kMoved].isOff);
    EXPECT_TRUE(std::filesystem::exists(set / "cameras-refined-1.json"));
}

TEST_F(RefinementPageTest, JointsFollowTheCalibrationAtOnce) {
    session.selection.setFrame(14);
    session.selection.setJoint({core::Side::Left, "joint3"});
    const core::JointReconstruction before = session.reconstructions.selected();
    refine();
    QTest::mouseClick(button(page, "Use the refined calibration"), Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([this] { return camerasFile() != QLatin1String("cameras.json"); }));
    look();
    session.selection.setJoint({core::Side::Left, "joint3"}); // it is not in the list of joints
    const core::JointReconstruction& after = session.reconstructions.selected();
    ASSERT_TRUE(after.hasPoint());
    EXPECT_LT(after.result.point->rmsPx, 0.8);
    EXPECT_FALSE(after.views[kMoved].outlier);
    ASSERT_TRUE(before.views[kMoved].errorPx && after.views[kMoved].errorPx);
    EXPECT_LT(*after.views[kMoved].errorPx, *before.views[kMoved].errorPx);
}

TEST_F(RefinementPageTest, AStopLeavesEverythingAsItWas) {
    session.rig.refine();
    ASSERT_TRUE(session.rig.isRefining());
    QTest::mouseClick(button(page, "Stop"), Qt::LeftButton);
    EXPECT_FALSE(session.rig.isRefining());
    look();
    EXPECT_FALSE(session.rig.proposal());
    EXPECT_TRUE(button(page, "Refine")->isEnabled());
}

TEST_F(RefinementPageTest, AFolderThatCannotBeWrittenIsSaidAndNothingChanges) {
    refine();
    const auto file = session.opened.dataset()->folder / "dataset.json";
    std::filesystem::rename(file, folder / "elsewhere.json");
    QTest::mouseClick(button(page, "Use the refined calibration"), Qt::LeftButton);
    look();
    EXPECT_TRUE(says(page, "dataset.json"));
    EXPECT_EQ(camerasFile(), QStringLiteral("cameras.json"));
    EXPECT_TRUE(session.rig.proposal()) << "it can be tried again";
}

TEST_F(RefinementPageTest, ArrowsShowTheMeanResidualOfEachCellTenTimesAsLong) {
    widgets::CameraGrid grid;
    grid.setCameras(session.opened.dataset()->cameras);
    widgets::ResidualArrows arrows(session.rig, grid);
    EXPECT_TRUE(grid.view(kMoved)->residualArrows().empty());
    arrows.setShown(true);
    const Eigen::Vector2d shift = *core::project(seen[kMoved], Eigen::Vector3d::Zero()) -
                                  *core::project(session.opened.dataset()->cameras[kMoved], Eigen::Vector3d::Zero());
    ASSERT_FALSE(grid.view(kMoved)->residualArrows().empty());
    for (const widgets::ResidualArrow& arrow : grid.view(kMoved)->residualArrows()) {
        const QPointF along = arrow.toPx - arrow.fromPx;
        EXPECT_NEAR(along.x(), 10 * shift.x(), 20);
        EXPECT_NEAR(along.y(), 10 * shift.y(), 20);
    }
    const std::size_t before = grid.view(kMoved)->residualArrows().size();
    refine();
    const auto& both = grid.view(kMoved)->residualArrows();
    ASSERT_EQ(both.size(), 2 * before) << "and those of the refined cameras";
    EXPECT_NE(both.front().colour, both.back().colour);
    EXPECT_LT(std::hypot((both.back().toPx - both.back().fromPx).x(), (both.back().toPx - both.back().fromPx).y()), 15);
    arrows.setShown(false);
    EXPECT_TRUE(grid.view(kMoved)->residualArrows().empty());
}

TEST(ResidualArrowCells, WeighTheirClicksAndIgnoreWrongOnes) {
    core::RigResiduals residuals;
    const auto add = [&](int camera, double x, double residualX, double weight) {
        core::RigResidual click;
        click.camera = camera;
        click.px = {x, 30};
        click.leftOutPx = {residualX, -1};
        click.weight = weight;
        residuals.clicks.push_back(click);
    };
    add(1, 10, 2, 1);
    add(1, 20, 4, 1);
    add(1, 500, 80, 0.001); // wrong, and alone in its cell
    add(0, 10, 9, 1);
    const auto arrows = widgets::residualArrows(residuals, 1, {800, 600}, Qt::red);
    ASSERT_EQ(arrows.size(), 1u);
    EXPECT_EQ(arrows[0].fromPx, QPointF(15, 30));
    EXPECT_EQ(arrows[0].toPx, QPointF(15 + 10 * 3, 30 - 10));
}

} // namespace
