// SPDX-License-Identifier: MIT
// Silhouettes in the real window: looked at, touched up with the brush, undone and redone apart from annotations.
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <opencv2/core.hpp>

#include "core/annotation/edits.h"
#include "core/contour/rasteriser.h"
#include "core/io/footage/image_file.h"
#include "tests/app/window_fixture.h"
#include "tests/support/pointer.h"
#include "widgets/panels/silhouettes/silhouette_page.h"

namespace {

class SilhouettesWindow : public test::WindowTest {
protected:
    void open() {
        window->actions().action(QStringLiteral("annotation.silhouettes"))->trigger();
        ASSERT_TRUE(app::waitUntilIdle(*window));
        ASSERT_TRUE(page());
    }
    void setBrush(bool on) {
        QAction* brush = window->actions().action(QStringLiteral("annotation.silhouetteBrush"));
        if (brush->isChecked() != on)
            brush->trigger();
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
    widgets::SilhouettePage* page() { return window->findChild<widgets::SilhouettePage*>(); }
    QAction* undo() { return window->actions().action(QStringLiteral("edit.undo")); }
    QAction* redo() { return window->actions().action(QStringLiteral("edit.redo")); }
    widgets::CameraView* view() { return window->workspaces().grid()->view(0); }

    cv::Mat mask(int index = 0) { return session().silhouettes.shown().at(index).silhouette.mask; }
    static cv::Mat trueMask(int index) {
        const core::Dataset dataset = test::tinyDataset();
        return core::renderHandsMask(dataset.cameras[static_cast<std::size_t>(index)], dataset.hands,
                                     test::tinyMotion(13)[12]);
    }
    /// The first view as it is seen, one value a pixel.
    QImage picture() {
        app::drawNow(*window);
        return view()->viewport()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    static int differingPixels(const QImage& a, const QImage& b) {
        int count = a.size() == b.size() ? 0 : a.width() * a.height();
        for (int y = 0; y < a.height() && a.size() == b.size(); ++y)
            for (int x = 0; x < a.width(); ++x)
                count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
        return count;
    }
    /// Draws a short stroke in a corner of the picture where nothing is.
    void stroke(Qt::MouseButton button = Qt::LeftButton) {
        const QPointF from = view()->imageToViewport({20, 20}), to = view()->imageToViewport({60, 20});
        test::drag(view()->viewport(), from, to, button);
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
    std::filesystem::path file() const { return dataset() / "masks" / "a-model" / "cam0" / "000012.png"; }
};

TEST_F(SilhouettesWindow, ShowsTheHandsOutlineInEveryView) {
    const QImage before = picture();
    open();
    ASSERT_EQ(session().silhouettes.shown().size(), 8u);
    for (int i = 0; i < 8; ++i)
        EXPECT_GT(core::maskOverlap(mask(i), trueMask(i)), 0.9) << i;
    const double scale = view()->scale() * view()->scale();
    const int hands = cv::countNonZero(mask());
    ASSERT_GT(hands, 1000);
    const int tinted = differingPixels(before, picture());
    EXPECT_GT(tinted, 0.8 * hands * scale) << "a tint that cannot be seen";
    EXPECT_LT(tinted, 1.5 * hands * scale + 500) << "not only the hands are tinted";
    page()->window()->close();
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_EQ(differingPixels(before, picture()), 0) << "the tint goes with the window";
}

TEST_F(SilhouettesWindow, StrokesAreUndoneAndRedoneWhileTheBrushIsOnAndAnnotationsStay) {
    session().document.push(core::placeEdit(session().document.annotations(),
                                            {12, session().document.rater(), test::kIndex, camera(0).name}, {5, 5}));
    const core::AnnotationSet annotated = session().document.annotations();
    open();
    setBrush(true);
    const cv::Mat found = mask().clone();
    ASSERT_EQ(found.at<uchar>(20, 40), 0);
    stroke();
    EXPECT_EQ(mask().at<uchar>(20, 40), 255);
    EXPECT_GT(cv::countNonZero(mask()), cv::countNonZero(found) + 500);
    EXPECT_EQ(cv::norm(core::readMask(file()), mask(), cv::NORM_INF), 0) << "a touch is on disk at once";
    EXPECT_TRUE(undo()->text().contains(QStringLiteral("cam0"))) << undo()->text().toStdString();

    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Ctrl+Z\"}\n"), 0) << errors.str();
    EXPECT_EQ(cv::norm(mask(), found, cv::NORM_INF), 0);
    EXPECT_FALSE(std::filesystem::exists(file())) << "what is found is not kept";
    EXPECT_EQ(session().document.annotations(), annotated);
    EXPECT_FALSE(undo()->isEnabled());
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Ctrl+Shift+Z\"}\n"), 0) << errors.str();
    EXPECT_EQ(mask().at<uchar>(20, 40), 255);

    stroke(Qt::RightButton);
    EXPECT_EQ(mask().at<uchar>(20, 40), 0) << "the right button takes away";
    setBrush(false);
    page()->window()->close();
    ASSERT_TRUE(app::waitUntilIdle(*window));
    undo()->trigger();
    EXPECT_TRUE(session().document.annotations().marks.empty()) << "without the window annotations are undone";
    EXPECT_EQ(session().silhouettes.undoStack()->index(), 2);
    EXPECT_TRUE(redo()->isEnabled());
}

TEST_F(SilhouettesWindow, AStrokeIsSeenWhileItIsDrawn) {
    open();
    setBrush(true);
    const QImage before = picture();
    const double low = 0.75 * camera(0).size.height; // below the view's title
    const QPointF from = view()->imageToViewport({20, low}), to = view()->imageToViewport({200, low});
    test::press(view()->viewport(), from);
    test::moveTo(view()->viewport(), to, Qt::LeftButton);
    EXPECT_GT(differingPixels(before, picture()), 100);
    EXPECT_EQ(session().silhouettes.undoStack()->count(), 0) << "not before the button is released";
    test::release(view()->viewport(), to);
    EXPECT_EQ(session().silhouettes.undoStack()->count(), 1);
}

TEST_F(SilhouettesWindow, TheKeyUndoesStrokesInTheWindowOfTheSilhouettesToo) {
    open();
    setBrush(true);
    stroke();
    setBrush(false);
    page()->window()->activateWindow();
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_EQ(play("{\"do\":\"key\",\"keys\":\"Ctrl+Z\"}\n"), 0) << errors.str();
    EXPECT_EQ(session().silhouettes.undoStack()->index(), 0);
    EXPECT_EQ(mask().at<uchar>(20, 40), 0);
}

} // namespace
