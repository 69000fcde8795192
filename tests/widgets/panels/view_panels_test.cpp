// SPDX-License-Identifier: MIT
#include "tests/widgets/panels/panel_fixture.h"
#include "widgets/panels/workspaces.h"

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
        bench.session.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
    }
    widgets::Workspaces spaces{bench};
};

TEST_F(ViewPanelsTest, HiddenAndReorderedCamerasAreRemembered) {
    auto* list = child<QListWidget>(*spaces.viewPanel());
    ASSERT_EQ(list->count(), 8);
    list->item(2)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(bench.shownCameras().size(), 7u);
    EXPECT_FALSE(spaces.grid()->view(2)->isVisible());
    reopen();
    EXPECT_EQ(bench.shownCameras().size(), 7u);
    EXPECT_EQ(std::count(bench.shownCameras().begin(), bench.shownCameras().end(), "cam2"), 0);
}

TEST_F(ViewPanelsTest, BrightnessIsOfOneViewOrAllAndIsRemembered) {
    widgets::ViewOptions& options = *spaces.options();
    options.setAdjustment("cam1", {0.25, 1.5, 0.75});
    EXPECT_DOUBLE_EQ(spaces.grid()->view(1)->adjustment().brightness, 0.25);
    EXPECT_DOUBLE_EQ(spaces.grid()->view(0)->adjustment().brightness, 0);
    reopen();
    EXPECT_DOUBLE_EQ(spaces.grid()->view(1)->adjustment().brightness, 0.25);
    EXPECT_DOUBLE_EQ(spaces.grid()->view(1)->adjustment().gamma, 0.75);
    options.setAdjustmentsFromText("nonsense\n0.5 2 1 cam 3 with blanks\n");
    EXPECT_DOUBLE_EQ(options.adjustment("cam 3 with blanks").contrast, 2);
    EXPECT_DOUBLE_EQ(options.adjustment("cam1").brightness, 0);
}

TEST_F(ViewPanelsTest, TheModelOfTheMarksIsALayer) {
    bench.model.setOn(true);
    settle();
    EXPECT_FALSE(bench.model.fit()) << "two joints a hand are not enough";
    spaces.layers()->setAnnotatedPose(core::HandPoses{test::tinyMotion(13).back()[0], core::Pose()}, 12);
    settle();
    spaces.grid()->finishDrawing();
    const QImage withModel = spaces.grid()->view(0)->grab().toImage();
    spaces.layers()->setAnnotatedPose(std::nullopt, -1);
    settle();
    spaces.grid()->finishDrawing();
    EXPECT_NE(withModel, spaces.grid()->view(0)->grab().toImage());
}

TEST_F(ViewPanelsTest, EveryPartHasItsName) {
    for (const char* name : {"scene", "joints", "diagram", "fit", "quality", "raters", "view", "curves", "views", "inspect", "benchmark", "cam7"})
        EXPECT_TRUE(spaces.part(QString::fromLatin1(name))) << name;
    EXPECT_FALSE(spaces.part(QStringLiteral("cam8")));
}

} // namespace
