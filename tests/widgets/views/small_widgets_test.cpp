// SPDX-License-Identifier: MIT
// The small parts around a view: title, message bar, loupe, cursor, saved pictures.
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/pointer.h"
#include "widgets/views/camera/camera_view.h"
#include "widgets/views/camera/loupe.h"
#include "widgets/views/camera/view_cursor.h"
#include "widgets/views/camera/view_title_bar.h"
#include "widgets/views/message_bar.h"
#include "widgets/views/picture_export.h"

namespace {

using namespace widgets;

TEST(ViewTitleBar, WarnsInColour) {
    ViewTitleBar bar;
    bar.resize(200, bar.sizeHint().height());
    bar.setTitle({"cam0", "+2", "0.8 px", false});
    const QColor calm = bar.grab().toImage().pixelColor(100, 1);
    bar.setTitle({"cam0", "+2", "14.2 px", true});
    const QColor warning = bar.grab().toImage().pixelColor(100, 1);
    EXPECT_EQ(calm, bar.palette().color(QPalette::Window));
    EXPECT_GT(warning.red(), warning.blue() + 100);
    EXPECT_LT(bar.sizeHint().height(), 24) << "one thin line";
    EXPECT_TRUE(bar.toolTip().contains(QStringLiteral("14.2 px")));
}

TEST(ViewTitleBar, HasAChipOfItsCamerasColourAndSaysWhereToClickNext) {
    ViewTitleBar bar;
    bar.resize(200, bar.sizeHint().height());
    ViewTitle title{"cam7", {}, {}, false};
    title.colour = QColor(10, 200, 90);
    bar.setTitle(title);
    EXPECT_EQ(bar.grab().toImage().pixelColor(10, bar.height() / 2), title.colour);
    EXPECT_EQ(bar.grab().toImage().pixelColor(100, 1), bar.palette().color(QPalette::Window));
    title.next = QStringLiteral("click here next");
    bar.setTitle(title);
    EXPECT_EQ(bar.grab().toImage().pixelColor(100, 1), bar.palette().color(QPalette::Highlight));
    EXPECT_TRUE(bar.toolTip().contains(title.next));
    title.warning = true;
    bar.setTitle(title);
    EXPECT_NE(bar.grab().toImage().pixelColor(100, 1), bar.palette().color(QPalette::Highlight))
        << "a warning comes first";
}

TEST(ViewTitleBar, LongTextsAreElidedNotOverlaid) {
    ViewTitleBar bar;
    bar.resize(60, bar.sizeHint().height());
    bar.setTitle({"a camera with a very long name", "and a detail", "123.4 px", false});
    EXPECT_FALSE(bar.grab().isNull());
}

TEST(ViewTitleBar, ALongRequestLeavesRoomForTheCamerasName) {
    ViewTitleBar bar;
    bar.resize(170, bar.sizeHint().height());
    ViewTitle title{"cam7", {}, {}, false};
    title.next = QStringLiteral("next");
    bar.setTitle(title);
    const QRect name(0, 0, bar.fontMetrics().horizontalAdvance(QStringLiteral("cam7")), bar.height());
    const QImage shortRequest = bar.grab(name).toImage();
    title.next = QStringLiteral("als N\u00e4chstes hier klicken, bitte, in dieser Ansicht");
    bar.setTitle(title);
    EXPECT_EQ(bar.grab(name).toImage(), shortRequest);
}

TEST(ViewTitleBar, ALongNameLeavesRoomForADetailThatMustStay) {
    ViewTitleBar bar;
    bar.resize(170, bar.sizeHint().height());
    const auto tellsDetailsApart = [&](bool keepsDetail) {
        ViewTitle title{"dch-thres:tau=45,forearm=ignore?", "cam0", "", false};
        title.keepsDetail = keepsDetail;
        bar.setTitle(title);
        const QImage first = bar.grab().toImage();
        title.detail = "cam7";
        bar.setTitle(title);
        return bar.grab().toImage() != first;
    };
    EXPECT_TRUE(tellsDetailsApart(true));
    EXPECT_FALSE(tellsDetailsApart(false));
}

TEST(MessageBar, KeepsTheDetailOfAnErrorInItsToolTip) {
    QWidget window;
    MessageBar bar(&window);
    bar.setMessage(QStringLiteral("nicht gefunden") + QChar(QChar::ParagraphSeparator) +
                   QStringLiteral("no such file"));
    EXPECT_EQ(bar.message(), QStringLiteral("nicht gefunden"));
    EXPECT_EQ(bar.findChild<QLabel*>()->toolTip(), QStringLiteral("no such file"));
}

TEST(MessageBar, AppearsWithTextAndCanBeDismissed) {
    CameraView view;
    view.setCamera(test::cameraRing(1)[0]);
    view.resize(270, 480);
    view.show();
    auto* bar = view.findChild<MessageBar*>();
    ASSERT_TRUE(bar);
    EXPECT_FALSE(bar->isVisible());
    view.setMessage(QStringLiteral("frame 41 of cam0.mp4 cannot be read: copy the file again"));
    EXPECT_TRUE(bar->isVisible());
    EXPECT_GT(bar->height(), 20);
    EXPECT_EQ(bar->y(), view.viewport()->y()) << "at the top of the picture";
    QSignalSpy dismissed(bar, &MessageBar::dismissed);
    test::click(bar->findChild<QToolButton*>(), {5, 5});
    EXPECT_FALSE(bar->isVisible());
    EXPECT_EQ(dismissed.count(), 1);
    EXPECT_TRUE(view.message().isEmpty());
}

TEST(Loupe, MagnifiesTheExactPlace) {
    QWidget parent;
    parent.resize(600, 600);
    parent.show();
    Loupe loupe(&parent);
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(Qt::black);
    image.setPixelColor(201, 150, Qt::green);
    const ImagePyramid pyramid(image);
    // Pixel 201 covers 200.5 .. 201.5: from 200.75 it lies to the right of the middle, but for a quarter of a pixel.
    loupe.show(pyramid, {}, {200.75, 150}, {300, 300}, 1);
    EXPECT_TRUE(loupe.isVisible());
    const QImage shown = loupe.grab().toImage();
    const QPoint middle(shown.width() / 2, shown.height() / 2);
    const auto isGreen = [&](int dx) { return shown.pixelColor(middle + QPoint(dx, -2)).green() > 200; };
    EXPECT_TRUE(isGreen(-1)); // 8 screen px per pixel: it begins 2 px left of the middle
    EXPECT_FALSE(isGreen(-4));
    EXPECT_TRUE(isGreen(4));
    EXPECT_FALSE(isGreen(8));
}

TEST(Loupe, StaysInsideAndBesideThePointer) {
    QWidget parent;
    parent.resize(300, 300);
    parent.show();
    Loupe loupe(&parent);
    const ImagePyramid pyramid(QImage(100, 100, QImage::Format_RGB32));
    for (const QPointF at : {QPointF(5, 5), QPointF(295, 5), QPointF(5, 295), QPointF(295, 295), QPointF(20, 280)}) {
        loupe.show(pyramid, {}, {50, 50}, at, 1);
        EXPECT_TRUE(parent.rect().contains(loupe.geometry())) << at.x() << " " << at.y();
        EXPECT_FALSE(loupe.geometry().contains(at.toPoint())) << at.x() << " " << at.y();
    }
}

TEST(Loupe, FollowsThePointerInAView) {
    CameraView view;
    view.setCamera(test::cameraRing(1)[0]);
    view.resize(400, 500);
    view.show();
    view.setImage(QImage(1080, 1920, QImage::Format_RGB32));
    auto* loupe = view.findChild<Loupe*>();
    ASSERT_TRUE(loupe);
    test::moveTo(view.viewport(), {100, 300});
    EXPECT_FALSE(loupe->isVisible());
    view.setLoupeShown(true);
    test::moveTo(view.viewport(), {100, 300});
    EXPECT_TRUE(loupe->isVisible());
    const QPoint before = loupe->pos();
    test::moveTo(view.viewport(), {120, 310});
    EXPECT_EQ(loupe->pos() - before, QPoint(20, 10));
    view.setLoupeShown(false);
    EXPECT_FALSE(loupe->isVisible());
}

TEST(PlacingCursor, HasAnOpenCentre) {
    const QCursor cursor = placingCursor();
    const QImage picture = cursor.pixmap().toImage();
    EXPECT_EQ(qAlpha(picture.pixel(cursor.hotSpot())), 0);
    EXPECT_EQ(picture.pixelColor(cursor.hotSpot() + QPoint(8, 0)), QColor(Qt::white));
}

TEST(PictureExport, SavesByTheSuffix) {
    QTemporaryDir folder;
    QImage image(4, 3, QImage::Format_RGB32);
    image.fill(Qt::red);
    const auto writeSvg = [](const QString& path) {
        QFile file(path);
        return file.open(QIODevice::WriteOnly) && file.write("<svg/>") > 0;
    };
    const PictureSource source{[&](double s) { return image.scaled(image.size() * s); }, writeSvg, "name", {}};
    const QString png = folder.filePath(QStringLiteral("a.png")), svg = folder.filePath(QStringLiteral("a.svg"));
    ASSERT_TRUE(savePicture(source, png));
    EXPECT_EQ(QImage(png).size(), QSize(8, 6)) << "files have twice the size on the screen";
    ASSERT_TRUE(savePicture(source, svg));
    EXPECT_TRUE(QFile::exists(svg));
    EXPECT_FALSE(QFile::exists(svg + QStringLiteral(".part")));
    EXPECT_FALSE(savePicture(source, folder.filePath(QStringLiteral("no/a.png"))));
    EXPECT_FALSE(savePicture(source, folder.filePath(QStringLiteral("no/a.svg"))));
}

TEST(PictureExport, CopiesToTheClipboard) {
    QWidget parent;
    QMenu menu;
    QImage image(4, 3, QImage::Format_RGB32);
    image.fill(Qt::blue);
    addPictureActions(menu, &parent, {[&](double) { return image; }, {}, "name", {}});
    ASSERT_EQ(menu.actions().size(), 2);
    menu.actions().front()->trigger();
    EXPECT_EQ(QApplication::clipboard()->image().pixelColor(1, 1), QColor(Qt::blue));
}

} // namespace
