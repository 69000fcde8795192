// SPDX-License-Identifier: MIT
#include "widgets/views/camera/camera_view.h"

#include <cmath>

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/pointer.h"

namespace {

using namespace widgets;
using core::Side;

const core::JointId kIndex{Side::Left, "index_mcp"};
const core::JointId kThumb{Side::Right, "thumb_ip"};

/// A shown view of a portrait camera that remembers what it said.
class CameraViewTest : public testing::Test {
protected:
    CameraViewTest() {
        view.setCamera(test::cameraRing(1)[0]);
        view.resize(270, 500);
        view.show();
        QApplication::processEvents();
        QObject::connect(
            &view, &CameraView::pointPlaced, [this](QPointF px) { placed.push_back(px); });
        QObject::connect(
            &view, &CameraView::pointWithdrawn, [this] { ++withdrawn; });
        QObject::connect(
            &view, &CameraView::markDragStarted, [this](auto& joint, QPointF) { dragStarted.push_back(joint); });
        QObject::connect(
            &view, &CameraView::markDragged, [this](auto&, QPointF px) { dragged.push_back(px); });
        QObject::connect(
            &view, &CameraView::markDropped, [this](auto&, QPointF px) { dropped.push_back(px); });
        QObject::connect(
            &view, &CameraView::markDragCancelled, [this](auto& joint) { cancelled.push_back(joint); });
        QObject::connect(&view, &CameraView::markSelected, [this](auto& joint) { selected.push_back(joint); });
    }

    static ViewMark mark(const core::JointId& joint, QPointF px, bool isSelected = false) {
        ViewMark m;
        m.joint = joint;
        m.px = px;
        m.selected = isSelected;
        return m;
    }

    QPointF onScreen(QPointF px) const { return view.imageToViewport(px); }
    static double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

    CameraView view;
    std::vector<QPointF> placed, dragged, dropped;
    std::vector<core::JointId> dragStarted, cancelled, selected;
    int withdrawn = 0;
};

TEST_F(CameraViewTest, FitsTheWholeImage) {
    EXPECT_TRUE(view.isFitted());
    const QPointF corner = onScreen({-0.5, -0.5}), opposite = onScreen({1079.5, 1919.5});
    const QSize room = view.viewport()->size();
    EXPECT_GE(corner.x(), -1e-9);
    EXPECT_GE(corner.y(), -1e-9);
    EXPECT_LE(opposite.x(), room.width() + 1e-9);
    EXPECT_LE(opposite.y(), room.height() + 1e-9);
    // It touches two sides and is centred.
    const QPointF size = opposite - corner;
    EXPECT_NEAR(std::max(size.x() / room.width(), size.y() / room.height()), 1, 1e-9);
    EXPECT_NEAR(corner.x(), room.width() - opposite.x(), 1e-9);
    EXPECT_NEAR(corner.y(), room.height() - opposite.y(), 1e-9);
}

TEST_F(CameraViewTest, ImageAndViewportMapOntoEachOtherExactly) {
    for (const double scale : {0.0, 0.31, 1.0, 7.77, 64.0}) {
        if (scale > 0)
            view.lookAt({500.3, 900.7}, scale);
        for (const QPointF px : {QPointF(0, 0), QPointF(512.25, 733.5), QPointF(1079, 1919)})
            EXPECT_LT(distance(view.viewportToImage(onScreen(px)), px), 1e-9) << scale;
        EXPECT_EQ(view.viewportTransform(), view.transform()) << "the scroll bars must not interfere";
    }
}

TEST_F(CameraViewTest, AClickPlacesTheExactPixelAtAnyZoom) {
    const QPointF px(512.37, 733.52);
    for (const double scale : {0.0, 0.2, 1.0, 3.3, 20.0}) {
        if (scale > 0)
            view.lookAt(px + QPointF(0.4, -0.3), scale);
        placed.clear();
        test::click(view.viewport(), onScreen(px));
        ASSERT_EQ(placed.size(), 1u);
        EXPECT_LT(distance(placed[0], px), 1e-6) << scale;
    }
}

TEST_F(CameraViewTest, AHandThatTrembledStillPlacesWhereItPressed) {
    const QPointF at = onScreen({600, 800});
    test::press(view.viewport(), at);
    test::moveTo(view.viewport(), at + QPointF(2, 1.5), Qt::LeftButton);
    test::release(view.viewport(), at + QPointF(2, 1.5));
    ASSERT_EQ(placed.size(), 1u);
    EXPECT_LT(distance(placed[0], {600, 800}), 1e-6);
}

TEST_F(CameraViewTest, AClickOnAnyMarkPlacesAndNeverDrags) {
    view.setMarks({mark(kThumb, {600, 800}), mark(kIndex, {100, 100}, true)});
    test::click(view.viewport(), onScreen({600, 800}));
    EXPECT_EQ(placed.size(), 1u);
    EXPECT_TRUE(dragStarted.empty());
    EXPECT_TRUE(selected.empty());
}

TEST_F(CameraViewTest, ADragOnAMarkMovesItAndKeepsTheGrabOffset) {
    view.setMarks({mark(kThumb, {600, 800})});
    const QPointF grabbed = onScreen({600, 800}) + QPointF(3, -2);
    const double scale = view.scale();
    test::drag(view.viewport(), grabbed, grabbed + QPointF(40, 25));
    ASSERT_EQ(dragStarted.size(), 1u);
    EXPECT_EQ(dragStarted[0], kThumb);
    ASSERT_EQ(dropped.size(), 1u);
    EXPECT_LT(distance(dropped[0], QPointF(600, 800) + QPointF(40, 25) / scale), 1e-6);
    EXPECT_LT(distance(dragged.back(), dropped[0]), 1e-9);
    EXPECT_TRUE(placed.empty());
}

TEST_F(CameraViewTest, OfTwoMarksTheSelectedOneIsDragged) {
    const QPointF place(600, 800), nearBy = place + QPointF(6, 0) / view.scale();
    view.setMarks({mark(kThumb, place), mark(kIndex, nearBy, true)});
    test::drag(view.viewport(), onScreen(place), onScreen(place) + QPointF(20, 0));
    ASSERT_EQ(dragStarted.size(), 1u);
    EXPECT_EQ(dragStarted[0], kIndex);
}

TEST_F(CameraViewTest, HitTestsCountScreenPixels) {
    view.setMarks({mark(kThumb, {600, 800})});
    for (const double scale : {0.15, 1.0, 30.0}) {
        view.lookAt({600, 800}, scale);
        EXPECT_TRUE(view.markAt(onScreen({600, 800}) + QPointF(8.9, 0))) << scale;
        EXPECT_FALSE(view.markAt(onScreen({600, 800}) + QPointF(9.1, 0))) << scale;
    }
}

TEST_F(CameraViewTest, ADragOnTheBackgroundPansAndPlacesNothing) {
    view.lookAt({540, 960}, 1);
    const QPointF before = onScreen({540, 960});
    test::drag(view.viewport(), {100, 100}, {120.5, 93.25});
    EXPECT_TRUE(placed.empty());
    EXPECT_LT(distance(onScreen({540, 960}), before + QPointF(20.5, -6.75)), 1e-9);
}

TEST_F(CameraViewTest, TheMiddleButtonPansEvenOnMarks) {
    view.lookAt({540, 960}, 1);
    view.setMarks({mark(kThumb, {540, 960}, true)});
    const QPointF from = onScreen({540, 960});
    test::drag(view.viewport(), from, from + QPointF(30, 10), Qt::MiddleButton);
    EXPECT_TRUE(dragStarted.empty());
    EXPECT_LT(distance(onScreen({540, 960}), from + QPointF(30, 10)), 1e-9);
}

TEST_F(CameraViewTest, TheWheelZoomsAtThePointer) {
    const QPointF at(77.3, 210.8), px = view.viewportToImage(at);
    const double before = view.scale();
    test::wheel(view.viewport(), at, 3);
    EXPECT_NEAR(view.scale() / before, std::pow(1.25, 3), 1e-9);
    EXPECT_LT(distance(view.viewportToImage(at), px), 1e-6);
    test::wheel(view.viewport(), at, -30);
    EXPECT_TRUE(view.isFitted()) << "zooming out ends at the whole image";
}

TEST_F(CameraViewTest, ZoomAndPanStayWhenTheImageChanges) {
    QImage image(1080, 1920, QImage::Format_RGB32);
    view.setImage(image);
    view.lookAt({300.4, 500.6}, 2.2);
    const QTransform before = view.viewportTransform();
    view.setImage(image.copy());
    view.setCamera(test::cameraRing(2)[1]);
    EXPECT_EQ(view.viewportTransform(), before);
}

TEST_F(CameraViewTest, ResizingKeepsTheMiddleUnlessFitted) {
    view.lookAt({300, 500}, 2);
    view.resize(400, 320);
    QApplication::processEvents();
    const QPointF middle(view.viewport()->width() / 2.0, view.viewport()->height() / 2.0);
    EXPECT_LT(distance(view.viewportToImage(middle), {300, 500}), 1e-6);
    EXPECT_NEAR(view.scale(), 2, 1e-12);
    view.fitImage();
    view.resize(500, 420);
    QApplication::processEvents();
    EXPECT_NEAR(view.scale(), view.viewport()->height() / 1920.0, 1e-12);
}

TEST_F(CameraViewTest, AltClickSelectsTheMarkAndPlacesNothing) {
    view.setMarks({mark(kThumb, {600, 800})});
    test::click(view.viewport(), onScreen({600, 800}) + QPointF(4, 0), Qt::LeftButton, Qt::AltModifier);
    ASSERT_EQ(selected.size(), 1u);
    EXPECT_EQ(selected[0], kThumb);
    test::click(view.viewport(), {20, 30}, Qt::LeftButton, Qt::AltModifier);
    EXPECT_EQ(selected.size(), 1u);
    EXPECT_TRUE(placed.empty());
}

TEST_F(CameraViewTest, ADoubleClickTakesItsFirstClickBack) {
    QSignalSpy maximised(&view, &CameraView::maximiseRequested);
    test::doubleClick(view.viewport(), {80, 90});
    EXPECT_EQ(maximised.count(), 1);
    EXPECT_EQ(placed.size(), 1u);
    EXPECT_EQ(withdrawn, 1);
    view.setPlacingEnabled(false);
    test::doubleClick(view.viewport(), {80, 90});
    EXPECT_EQ(maximised.count(), 2);
    EXPECT_EQ(withdrawn, 1) << "nothing was placed, so nothing is taken back";
}

TEST_F(CameraViewTest, WithoutPlacingAClickDoesNothingAndADragPans) {
    view.setPlacingEnabled(false);
    view.lookAt({540, 960}, 1);
    view.setMarks({mark(kThumb, {540, 960}, true)});
    const QPointF from = onScreen({540, 960});
    test::click(view.viewport(), from);
    test::drag(view.viewport(), from, from + QPointF(15, 0));
    EXPECT_TRUE(placed.empty());
    EXPECT_TRUE(dragStarted.empty());
    EXPECT_LT(distance(onScreen({540, 960}), from + QPointF(15, 0)), 1e-9);
}

TEST_F(CameraViewTest, EscapeCancelsADragOnly) {
    view.setMarks({mark(kThumb, {600, 800})});
    const QPointF at = onScreen({600, 800});
    QKeyEvent idle(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QApplication::sendEvent(&view, &idle);
    EXPECT_FALSE(idle.isAccepted()) << "Escape is the window's";
    test::press(view.viewport(), at);
    test::moveTo(view.viewport(), at + QPointF(10, 10), Qt::LeftButton);
    QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QApplication::sendEvent(&view, &escape);
    EXPECT_TRUE(escape.isAccepted());
    test::moveTo(view.viewport(), at + QPointF(30, 10), Qt::LeftButton);
    test::release(view.viewport(), at + QPointF(30, 10));
    ASSERT_EQ(cancelled.size(), 1u);
    EXPECT_EQ(cancelled[0], kThumb);
    EXPECT_TRUE(dropped.empty());
    EXPECT_TRUE(placed.empty());
}

TEST_F(CameraViewTest, ARightClickAsksForAMenuAtTheMark) {
    view.setMarks({mark(kThumb, {600, 800})});
    std::vector<std::pair<QPointF, core::JointId>> asked;
    QObject::connect(&view, &CameraView::contextMenuRequested,
                     [&](QPointF px, const core::JointId& joint, QPoint) { asked.emplace_back(px, joint); });
    test::click(view.viewport(), onScreen({600, 800}), Qt::RightButton);
    test::click(view.viewport(), onScreen({60, 80}), Qt::RightButton);
    ASSERT_EQ(asked.size(), 2u);
    EXPECT_EQ(asked[0].second, kThumb);
    EXPECT_LT(distance(asked[0].first, {600, 800}), 1e-6);
    EXPECT_TRUE(asked[1].second.joint.empty());
    EXPECT_TRUE(placed.empty());
}

TEST_F(CameraViewTest, PanningNeverLosesTheImage) {
    view.panBy({-1e5, 1e5});
    const QRectF image(onScreen({-0.5, -0.5}), onScreen({1079.5, 1919.5}));
    const QRectF seen = image & QRectF(view.viewport()->rect());
    EXPECT_GE(seen.width(), 39);
    EXPECT_GE(seen.height(), 39);
}

TEST_F(CameraViewTest, PixelsOfTheImageLieWhereTheMapSays) {
    QImage image(1080, 1920, QImage::Format_RGB32);
    image.fill(Qt::black);
    image.setPixelColor(517, 731, Qt::red);
    view.setImage(image);
    view.lookAt({517, 731}, 11);
    const QImage shown = view.viewport()->grab().toImage();
    for (const QPointF inside : {QPointF(517, 731), QPointF(516.6, 730.6), QPointF(517.4, 731.4)})
        EXPECT_EQ(shown.pixelColor(onScreen(inside).toPoint()), QColor(Qt::red));
    for (const QPointF outside : {QPointF(516.3, 731), QPointF(517.7, 731), QPointF(517, 730.3), QPointF(517, 731.7)})
        EXPECT_EQ(shown.pixelColor(onScreen(outside).toPoint()), QColor(Qt::black));
}

TEST_F(CameraViewTest, ShrunkImagesAreAveragedNotSampled) {
    QImage image(1080, 1920, QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.setPixel(x, y, (x + y) % 2 ? qRgb(255, 255, 255) : qRgb(0, 0, 0));
    view.setImage(image);
    const QImage shown = view.viewport()->grab().toImage();
    const QColor middle = shown.pixelColor(onScreen({540, 960}).toPoint());
    EXPECT_NEAR(middle.red(), 128, 4);
}

TEST_F(CameraViewTest, AdjustmentBrightensOnlyWhatIsShown) {
    QImage image(1080, 1920, QImage::Format_RGB32);
    image.fill(QColor(100, 100, 100));
    view.setImage(image);
    view.setAdjustment({0.2, 1, 1});
    const QImage shown = view.viewport()->grab().toImage();
    EXPECT_NEAR(shown.pixelColor(onScreen({540, 960}).toPoint()).red(), 151, 1);
    EXPECT_EQ(image.pixelColor(540, 960).red(), 100);
}

TEST_F(CameraViewTest, HiddenOverlaysLeaveTheImageAlone) {
    QImage image(1080, 1920, QImage::Format_RGB32);
    image.fill(QColor(90, 60, 30));
    view.setImage(image);
    const QImage bare = view.viewport()->grab().toImage();
    view.setMarks({mark(kThumb, {600, 800}, true)});
    view.setSkeleton({{{100, 100}, {900, 1700}, Qt::green}});
    view.setEpipolarGuides({{{{0, 900}, {1079, 1000}}, Qt::yellow}});
    view.setEllipse(UncertaintyEllipse{{600, 800}, 100, 50, 0.3, Qt::white});
    QImage field(108, 192, QImage::Format_ARGB32_Premultiplied);
    field.fill(Qt::blue);
    view.setFieldImage(field);
    EXPECT_NE(view.viewport()->grab().toImage(), bare);
    view.setOverlaysHidden(true);
    EXPECT_EQ(view.viewport()->grab().toImage(), bare);
    view.setOverlaysHidden(false);
    EXPECT_NE(view.viewport()->grab().toImage(), bare);
}

TEST_F(CameraViewTest, SavedPictureIsThatOnTheScreen) {
    QImage image(1080, 1920, QImage::Format_RGB32);
    image.fill(QColor(90, 60, 30));
    view.setImage(image);
    view.setMarks({mark(kThumb, {600, 800}, true)});
    const QImage onTheScreen = view.viewport()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    const QImage saved = view.grabPicture(1);
    ASSERT_EQ(saved.size(), onTheScreen.size());
    int different = 0;
    for (int y = 0; y < saved.height(); ++y)
        for (int x = 0; x < saved.width(); ++x)
            different += (saved.pixel(x, y) & 0xFFFFFF) != (onTheScreen.pixel(x, y) & 0xFFFFFF);
    EXPECT_EQ(different, 0);
    EXPECT_EQ(view.grabPicture(2).size(), view.viewport()->size() * 2);
}

TEST_F(CameraViewTest, PicturesHaveNoPixelThatNobodyPaints) {
    view.resize(150, 150);
    const QSizeF shown = view.viewport()->size();
    const double scale = (shown.height() + 0.6) / shown.height(); // the last row is a part of a pixel
    const auto pictureOver = [&](const QColor& before) {
        for (int i = 0; i < 8; ++i) { // what the memory held
            QImage waste((shown * scale).toSize(), QImage::Format_RGB32);
            waste.fill(before);
        }
        return view.grabPicture(scale);
    };
    const QImage picture = pictureOver(Qt::white);
    ASSERT_EQ(picture.height(), static_cast<int>(shown.height()) + 1);
    EXPECT_EQ(picture, pictureOver(Qt::red));
    EXPECT_EQ(picture.pixelColor(0, picture.height() - 1), picture.pixelColor(0, 0)) << "the ground";
}

} // namespace
