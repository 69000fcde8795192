// SPDX-License-Identifier: MIT
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/workspaces/workspaces.h"

namespace {

class ViewPanelsTest : public test::PanelTest {
protected:
    ViewPanelsTest() {
        spaces.resize(1366, 700);
        spaces.show();
        reopen();
    }
    /// The workspaces came after the dataset was opened: once more, so that they know.
    void reopen() {
        session.opened.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
    }
    widgets::Workspaces spaces{session};
};

TEST_F(ViewPanelsTest, HiddenAndReorderedCamerasAreRemembered) {
    auto* list = child<QListWidget>(*spaces.viewPanel());
    ASSERT_EQ(list->count(), 8);
    list->item(2)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(session.shownCameras.names().size(), 7u);
    EXPECT_FALSE(spaces.grid()->view(2)->isVisible());
    reopen();
    EXPECT_EQ(session.shownCameras.names().size(), 7u);
    EXPECT_EQ(std::count(session.shownCameras.names().begin(), session.shownCameras.names().end(), "cam2"), 0);
}

TEST_F(ViewPanelsTest, BrightnessIsOfOneViewOrAllAndIsRemembered) {
    widgets::ViewOptions& options = *spaces.options();
    options.setAdjustment("cam1", {0.25, 1.5, 0.75});
    EXPECT_DOUBLE_EQ(spaces.grid()->view(1)->adjustment().brightness, 0.25);
    EXPECT_DOUBLE_EQ(spaces.grid()->view(0)->adjustment().brightness, 0);
    reopen();
    EXPECT_DOUBLE_EQ(spaces.grid()->view(1)->adjustment().brightness, 0.25);
    EXPECT_DOUBLE_EQ(spaces.grid()->view(1)->adjustment().gamma, 0.75);
    session.selection.setCamera("cam1");
    auto* brightness = child<QSlider>(*spaces.viewPanel(), 1); // after the mesh's opacity
    EXPECT_EQ(brightness->value(), 25);
    options.setAdjustmentsFromText("nonsense\n0.5 2 1 cam 3 with blanks\n");
    EXPECT_DOUBLE_EQ(options.adjustment("cam 3 with blanks").contrast, 2);
    EXPECT_DOUBLE_EQ(options.adjustment("cam1").brightness, 0);
    EXPECT_EQ(brightness->value(), 0) << "the slider says what is shown";
}

TEST_F(ViewPanelsTest, TheModelOfTheMarksIsALayer) {
    session.model.setOn(true);
    for (const core::Bone& bone : session.opened.dataset()->hands[0].skeleton.bones)
        for (const int camera : {0, 3, 5})
            click({core::Side::Left, bone.name}, camera);
    settle();
    EXPECT_FALSE(session.model.fit()) << "two joints of a hand are not enough";
    spaces.layers()->setAnnotatedPose(core::HandPoses{test::tinyMotion(13).back()[0], core::Pose()}, 12);
    settle();
    spaces.grid()->finishDrawing();
    const QImage withModel = spaces.grid()->view(0)->grab().toImage();
    spaces.layers()->setAnnotatedPose(std::nullopt, -1);
    settle();
    spaces.grid()->finishDrawing();
    EXPECT_NE(withModel, spaces.grid()->view(0)->grab().toImage());
}

TEST_F(ViewPanelsTest, TheSelectedJointIsNamedInTheCurrentViewOnly) {
    for (const int camera : {0, 3})
        click(index, camera);
    settle();
    for (const char* name : {"cam0", "cam3"}) {
        session.selection.setCamera(name);
        for (const widgets::CameraView* view : spaces.grid()->views()) {
            const auto& marks = view->marks();
            const bool isNamed =
                std::any_of(marks.begin(), marks.end(), [](const widgets::ViewMark& mark) { return mark.named; });
            EXPECT_EQ(isNamed, view->camera().name == name) << view->camera().name;
        }
    }
}

TEST_F(ViewPanelsTest, EveryPartHasItsName) {
    for (const char* name : {"scene", "joints", "diagram", "fit", "quality", "raters", "view", "curves", "views",
                             "inspect", "benchmark", "cam7"})
        EXPECT_TRUE(spaces.part(QString::fromLatin1(name))) << name;
    EXPECT_FALSE(spaces.part(QStringLiteral("cam8")));
}

} // namespace
