// SPDX-License-Identifier: MIT
#include "widgets/document/annotator.h"

#include <functional>

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "tests/support/recordings/ring_dataset.h"

namespace {

using namespace widgets;

const core::JointId kIndex{core::Side::Left, "index_mcp"};
const core::JointId kThumb{core::Side::Left, "thumb_ip"};

class AnnotatorTest : public testing::Test {
protected:
    AnnotatorTest() {
        document.setRater("ann");
        document.open({});
        reconstructions.setDataset(dataset);
        annotator.setDataset(dataset);
        joints.setCustom({kIndex, kThumb});
        std::vector<std::string> cameras;
        for (const core::Camera& camera : dataset->cameras)
            cameras.push_back(camera.name);
        shown.setNames(cameras);
        selection.setFrameCount(300);
        selection.setFrame(12);
        selection.setJoint(kIndex);
    }
    Eigen::Vector2d truth(int camera) const {
        return *core::project(dataset->cameras[static_cast<std::size_t>(camera)], point);
    }
    void click(int camera) { annotator.place("cam" + std::to_string(camera), truth(camera)); }
    std::optional<core::Mark> mark(int camera, const core::JointId& joint = kIndex) const {
        return core::markAt(document.annotations(), {12, "ann", joint, "cam" + std::to_string(camera)});
    }

    std::shared_ptr<const core::Dataset> dataset = std::make_shared<const core::Dataset>(test::ringDataset(4));
    Eigen::Vector3d point{20, -15, 30};
    Selection selection;
    AnnotationDocument document;
    JointList joints;
    Reconstructions reconstructions{document, selection};
    ShownCameras shown;
    Annotator annotator{document, selection, reconstructions, joints, shown};
};

TEST_F(AnnotatorTest, PointsStateWhatTheClicksOfTheRaterAreWorth) {
    for (const int camera : {0, 1, 2, 3})
        click(camera);
    selection.setJoint(kIndex); // the last click went on to the next joint
    EXPECT_TRUE(reconstructions.options().isSigmaAssumed);
    const Eigen::Matrix3d assumed = reconstructions.selected().result.point->covariance;
    core::ClickSigmas sigmas;
    sigmas.raters["ann"] = {.clickPx = 3, .clickPxByCamera = {3, 3, 3, 3}, .isAssumed = false};
    sigmas.systematicPx = {4, 4, 4, 4};
    QSignalSpy changed(&reconstructions, &Reconstructions::changed);
    reconstructions.setClickSigmas(sigmas);
    EXPECT_EQ(changed.count(), 1);
    EXPECT_FALSE(reconstructions.options().isSigmaAssumed);
    const Eigen::Matrix3d known = reconstructions.selected().result.point->covariance;
    EXPECT_NEAR(known.trace() / assumed.trace(), 25, 1e-6);
    EXPECT_NEAR(reconstructions.find(kIndex)->result.point->covariance.trace(), known.trace(), 1e-9);
    document.setRater("bob");
    EXPECT_TRUE(reconstructions.options().isSigmaAssumed);
}

TEST_F(AnnotatorTest, TwoClicksMakeAPoint) {
    click(0);
    EXPECT_FALSE(reconstructions.selected().hasPoint());
    click(2);
    ASSERT_TRUE(reconstructions.selected().hasPoint());
    EXPECT_LT((reconstructions.selected().result.point->pointInWorld - point).norm(), 1e-3);
    EXPECT_EQ(selection.camera(), "cam2");
    EXPECT_EQ(document.undoStack()->count(), 2);
}

TEST_F(AnnotatorTest, AcceptFillsTheNextViewWithoutAMark) {
    click(0);
    click(1);
    annotator.accept();
    ASSERT_TRUE(mark(2));
    EXPECT_EQ(mark(2)->placement, core::Placement::Auto);
    EXPECT_LT((mark(2)->px - truth(2)).norm(), 1e-3);
    EXPECT_EQ(selection.camera(), "cam2");
    annotator.accept();
    EXPECT_TRUE(mark(3));
}

TEST_F(AnnotatorTest, NothingToAcceptIsSaid) {
    QSignalSpy said(&annotator, &Annotator::nothingDone);
    annotator.accept();
    EXPECT_EQ(said.count(), 1);
    EXPECT_EQ(document.undoStack()->count(), 0);
}

TEST_F(AnnotatorTest, NextJointWhenEveryViewIsDone) {
    for (int camera = 0; camera < 3; ++camera)
        click(camera);
    EXPECT_EQ(selection.joint(), kIndex);
    selection.setCamera("cam3");
    annotator.toggleUnplaceable();
    EXPECT_EQ(selection.joint(), kThumb);
}

TEST_F(AnnotatorTest, StaysWhenAutoAdvanceIsOff) {
    annotator.setAutoAdvance(false);
    for (int camera = 0; camera < 4; ++camera)
        click(camera);
    EXPECT_EQ(selection.joint(), kIndex);
}

TEST_F(AnnotatorTest, WithdrawnClickLeavesNoTrace) {
    for (int camera = 0; camera < 4; ++camera)
        click(camera);
    ASSERT_EQ(selection.joint(), kThumb);
    const auto before = document.annotations();
    click(0);
    annotator.withdrawPlace();
    EXPECT_EQ(document.annotations(), before);
    EXPECT_EQ(document.undoStack()->count(), 4);
    EXPECT_FALSE(document.undoStack()->canRedo());
    EXPECT_EQ(selection.joint(), kThumb);
}

TEST_F(AnnotatorTest, DragIsOneStep) {
    click(0);
    annotator.drag("cam0", kIndex, truth(0) + Eigen::Vector2d(5, 0));
    annotator.drag("cam0", kIndex, truth(0) + Eigen::Vector2d(9, 0));
    EXPECT_EQ(document.undoStack()->count(), 1);
    annotator.drop("cam0", kIndex, truth(0) + Eigen::Vector2d(10, 0));
    EXPECT_EQ(document.undoStack()->count(), 2);
    EXPECT_DOUBLE_EQ(mark(0)->px.x(), truth(0).x() + 10);
    document.undoStack()->undo();
    EXPECT_EQ(mark(0)->px, truth(0));
}

TEST_F(AnnotatorTest, CancelledDragChangesNothing) {
    click(0);
    annotator.drag("cam0", kIndex, {1, 2});
    annotator.cancelDrag();
    EXPECT_EQ(mark(0)->px, truth(0));
    EXPECT_EQ(document.undoStack()->count(), 1);
}

TEST_F(AnnotatorTest, OccludedIsSetAndTakenBackByTheSameKey) {
    click(0);
    annotator.toggleOccluded();
    EXPECT_EQ(mark(0)->state, core::MarkState::Occluded);
    annotator.toggleOccluded();
    EXPECT_EQ(mark(0)->state, core::MarkState::Visible);
}

TEST_F(AnnotatorTest, OccludedAcceptsAPreplacedMark) {
    click(0);
    click(1);
    selection.setCamera("cam3");
    annotator.toggleOccluded();
    ASSERT_TRUE(mark(3));
    EXPECT_EQ(mark(3)->state, core::MarkState::Occluded);
    EXPECT_EQ(mark(3)->placement, core::Placement::Auto);
    EXPECT_EQ(document.undoStack()->count(), 3);
}

TEST_F(AnnotatorTest, NudgesOfOneMarkAreOneStep) {
    click(0);
    click(1);
    for (int i = 0; i < 4; ++i)
        annotator.nudge({0.25, 0});
    EXPECT_EQ(document.undoStack()->count(), 3);
    EXPECT_DOUBLE_EQ(mark(1)->px.x(), truth(1).x() + 1);
    selection.setCamera("cam0");
    annotator.nudge({0, 1});
    EXPECT_EQ(document.undoStack()->count(), 4);
}

TEST_F(AnnotatorTest, ANudgedProposalStartsWhereItIsShown) {
    core::Edit guess;
    guess.marks.push_back({{12, "ann", kIndex, "cam2"},
                           std::nullopt,
                           core::Mark{{30, 40}, core::Placement::Proposed, core::MarkState::Visible}});
    document.push(guess);
    click(0);
    click(1); // from now on the clicks say better where it is
    selection.setCamera("cam2");
    annotator.nudge({1, 0});
    ASSERT_TRUE(mark(2));
    EXPECT_EQ(mark(2)->placement, core::Placement::Manual);
    EXPECT_LT((mark(2)->px - truth(2) - Eigen::Vector2d(1, 0)).norm(), 1e-6);
}

TEST_F(AnnotatorTest, SteppingThroughCamerasGoesAroundTheEnd) {
    selection.setCamera("cam3");
    annotator.stepCamera(1);
    EXPECT_EQ(selection.camera(), "cam0");
    annotator.stepCamera(-1);
    EXPECT_EQ(selection.camera(), "cam3");
}

TEST_F(AnnotatorTest, StepsOfFramesStayInside) {
    annotator.stepFrame(-100);
    EXPECT_EQ(selection.frame(), 0);
    annotator.stepFrame(1000);
    EXPECT_EQ(selection.frame(), 299);
}

TEST_F(AnnotatorTest, AClickOutsideThePictureIsRefusedAndSaysSo) {
    QSignalSpy said(&annotator, &Annotator::nothingDone);
    for (const Eigen::Vector2d& px : {Eigen::Vector2d(-3, 100), Eigen::Vector2d(100, -0.6), Eigen::Vector2d(1080, 100),
                                      Eigen::Vector2d(100, 1920.2)})
        annotator.place("cam1", px);
    EXPECT_TRUE(document.annotations().marks.empty());
    ASSERT_EQ(said.count(), 4);
    EXPECT_TRUE(said[0][0].toString().contains(QStringLiteral("cam1"))) << said[0][0].toString().toStdString();
    annotator.place("cam1", {-0.4, 1919.4}); // of the outermost pixels
    ASSERT_TRUE(mark(1));
    EXPECT_EQ(mark(1)->px, Eigen::Vector2d(0, 1919));
}

TEST_F(AnnotatorTest, ADragStaysInThePictureAndADropOutsideChangesNothing) {
    click(0);
    QSignalSpy said(&annotator, &Annotator::nothingDone);
    annotator.drag("cam0", kIndex, {-50, 300});
    EXPECT_EQ(mark(0)->px, Eigen::Vector2d(0, 300));
    annotator.drop("cam0", kIndex, {-50, 300});
    EXPECT_EQ(mark(0)->px, truth(0));
    EXPECT_EQ(document.undoStack()->count(), 1);
    EXPECT_EQ(said.count(), 1);
}

TEST_F(AnnotatorTest, NudgesStopAtTheEdge) {
    annotator.place("cam0", {1078.5, 0.5});
    QSignalSpy said(&annotator, &Annotator::nothingDone);
    for (int i = 0; i < 5; ++i) {
        annotator.nudge({1, 0});
        annotator.nudge({0, -1});
    }
    EXPECT_EQ(mark(0)->px, Eigen::Vector2d(1079, 0));
    EXPECT_GT(said.count(), 0);
}

TEST_F(AnnotatorTest, CorrectionsOfAFinishedJointSelectNoOther) {
    for (int camera = 0; camera < 4; ++camera)
        click(camera);
    ASSERT_EQ(selection.joint(), kThumb) << "placed in the last view";
    const auto corrects = [&](const char* what, const std::function<void()>& correction) {
        selection.setJoint(kIndex);
        selection.setCamera("cam1");
        correction();
        EXPECT_EQ(selection.joint(), kIndex) << what;
    };
    corrects(
        "a drag",
        [&] {
            annotator.drag("cam1", kIndex, truth(1) + Eigen::Vector2d(1, 0));
            annotator.drop("cam1", kIndex, truth(1) + Eigen::Vector2d(1, 0));
        });
    corrects(
        "a nudge",
        [&] {
            annotator.nudge({0.25, 0});
        });
    corrects(
        "a click", [&] { annotator.place("cam1", truth(1)); });
    corrects("occluded", [&] { annotator.toggleOccluded(); });
    corrects("deleted and clicked again", [&] {
        annotator.remove();
        click(1);
    });
    corrects(
        "deleted everywhere and clicked again",
        [&] {
            annotator.removeInAllViews();
            for (int camera = 0; camera < 4; ++camera)
                click(camera);
        });
    corrects("cannot be placed", [&] { annotator.toggleUnplaceable(); });
    selection.setFrame(13); // another frame is another joint
    selection.setJoint(kIndex);
    for (int camera = 0; camera < 4; ++camera)
        click(camera);
    EXPECT_EQ(selection.joint(), kThumb);
}

TEST_F(AnnotatorTest, ADragThatFinishesAJointStaysThere) {
    for (int camera = 0; camera < 3; ++camera)
        click(camera);
    annotator.drag("cam3", kIndex, truth(3));
    annotator.drop("cam3", kIndex, truth(3));
    EXPECT_EQ(reconstructions.selected().status, core::JointStatus::Done);
    EXPECT_EQ(selection.joint(), kIndex);
}

TEST_F(AnnotatorTest, AWithdrawnClickDoesNotFinishItsJoint) {
    for (int camera = 0; camera < 4; ++camera)
        click(camera);
    annotator.withdrawPlace();
    ASSERT_EQ(selection.joint(), kIndex);
    click(3);
    EXPECT_EQ(selection.joint(), kThumb);
}

TEST_F(AnnotatorTest, NothingToAcceptInTheFrameIsSaid) {
    QSignalSpy said(&annotator, &Annotator::nothingDone);
    annotator.acceptFrame();
    EXPECT_EQ(said.count(), 1);
    annotator.removeInAllViews();
    EXPECT_EQ(said.count(), 2);
    EXPECT_EQ(document.undoStack()->count(), 0);
}

TEST_F(AnnotatorTest, ViewsWithoutAPictureGetNoMark) {
    reconstructions.setPictureGaps({{"cam3"}, {}});
    click(0);
    click(1);
    annotator.acceptAllViews();
    EXPECT_TRUE(mark(2));
    EXPECT_FALSE(mark(3));
    EXPECT_EQ(selection.joint(), kThumb) << "every view with a picture is placed";
    QSignalSpy said(&annotator, &Annotator::nothingDone);
    annotator.place("cam3", {100, 100});
    EXPECT_EQ(said.count(), 1);
    EXPECT_FALSE(mark(3, kThumb));
}

} // namespace
