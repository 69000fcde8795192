// SPDX-License-Identifier: MIT
#include "widgets/views/camera/camera_grid.h"

#include <ctime>

#include <QApplication>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/pointer.h"

namespace {

using namespace widgets;

class CameraGridTest : public testing::Test {
protected:
    CameraGridTest() {
        grid.setCameras(test::cameraRing(8));
        grid.resize(1330, 980);
        grid.show();
        QApplication::processEvents();
    }
    std::vector<int> shown() const {
        std::vector<int> result;
        for (int i = 0; i < grid.count(); ++i)
            if (grid.view(i)->isVisible())
                result.push_back(i);
        return result;
    }
    CameraGrid grid;
};

TEST_F(CameraGridTest, AnyNumberOfViewsFitsWithoutOverlap) {
    for (int count = 1; count <= 16; ++count) {
        grid.setCameras(test::cameraRing(count));
        QApplication::processEvents();
        ASSERT_EQ(grid.count(), count);
        for (int i = 0; i < count; ++i) {
            EXPECT_TRUE(grid.rect().contains(grid.view(i)->geometry())) << i << " of " << count;
            EXPECT_GT(grid.view(i)->viewport()->height(), 100);
            for (int j = 0; j < i; ++j)
                EXPECT_FALSE(grid.view(i)->geometry().intersects(grid.view(j)->geometry())) << i << " " << j;
        }
    }
}

TEST_F(CameraGridTest, EightPortraitViewsStandInTwoRows) {
    EXPECT_EQ(grid.view(0)->y(), grid.view(3)->y());
    EXPECT_EQ(grid.view(4)->y(), grid.view(7)->y());
    EXPECT_GT(grid.view(4)->y(), grid.view(0)->y() + 300);
    EXPECT_EQ(grid.view(1)->x(), grid.view(5)->x());
}

TEST_F(CameraGridTest, ADoubleClickMaximisesAndGoesBack) {
    QSignalSpy changed(&grid, &CameraGrid::maximisedChanged);
    grid.view(2)->lookAt({300, 400}, 1.5);
    test::doubleClick(grid.view(5)->viewport(), {60, 80});
    QApplication::processEvents();
    EXPECT_EQ(grid.maximised(), 5);
    EXPECT_EQ(shown(), std::vector<int>{5});
    EXPECT_GT(grid.view(5)->width(), 1300);
    test::doubleClick(grid.view(5)->viewport(), {60, 80});
    QApplication::processEvents();
    EXPECT_EQ(grid.maximised(), -1);
    EXPECT_EQ(shown().size(), 8u);
    EXPECT_EQ(changed.count(), 2);
    EXPECT_NEAR(grid.view(2)->scale(), 1.5, 1e-12) << "the others keep their zoom";
}

TEST_F(CameraGridTest, TheTitleMaximisesToo) {
    auto* title = grid.view(3)->findChild<ViewTitleBar*>();
    ASSERT_TRUE(title);
    test::sendMouse(title, QEvent::MouseButtonDblClick, {20, 5}, Qt::LeftButton, Qt::LeftButton);
    EXPECT_EQ(grid.maximised(), 3);
}

TEST_F(CameraGridTest, AClickMakesAViewTheCurrentOne) {
    QSignalSpy changed(&grid, &CameraGrid::currentChanged);
    test::click(grid.view(6)->viewport(), {30, 30});
    EXPECT_EQ(grid.current(), 6);
    EXPECT_EQ(changed.count(), 1);
    const QColor accent = grid.palette().color(QPalette::Highlight);
    const QImage picture = grid.grab().toImage();
    EXPECT_EQ(picture.pixelColor(grid.view(6)->geometry().topLeft() - QPoint(1, -40)), accent);
    EXPECT_NE(picture.pixelColor(grid.view(0)->geometry().topLeft() - QPoint(1, -40)), accent);
}

TEST_F(CameraGridTest, OrderHidesAndRearranges) {
    grid.setOrder({7, 0, 3});
    QApplication::processEvents();
    EXPECT_EQ(shown(), (std::vector<int>{0, 3, 7}));
    EXPECT_LT(grid.view(7)->x(), grid.view(0)->x());
    EXPECT_LT(grid.view(0)->x(), grid.view(3)->x());
}

TEST_F(CameraGridTest, ColumnsCanBeFixed) {
    grid.setFixedColumns(3);
    QApplication::processEvents();
    EXPECT_EQ(grid.view(0)->y(), grid.view(2)->y());
    EXPECT_GT(grid.view(3)->y(), grid.view(2)->y());
    EXPECT_EQ(grid.view(3)->x(), grid.view(0)->x());
}

TEST_F(CameraGridTest, EightRowsOfASmallWindowDoNotOverlap) {
    grid.setFixedColumns(1);
    grid.resize(930, 330);
    QApplication::processEvents();
    for (int i = 0; i < grid.count(); ++i) {
        EXPECT_TRUE(grid.rect().contains(grid.view(i)->geometry())) << i;
        EXPECT_GT(grid.view(i)->viewport()->height(), 10) << "below the title";
        if (i > 0)
            EXPECT_FALSE(grid.view(i)->geometry().intersects(grid.view(i - 1)->geometry())) << i;
    }
}

TEST_F(CameraGridTest, ViewsAreFoundByTheirCamera) {
    EXPECT_EQ(grid.view(QStringLiteral("cam4")), grid.view(4));
    EXPECT_EQ(grid.view(QStringLiteral("cam9")), nullptr);
}

TEST_F(CameraGridTest, RepaintsOfAllViewsAreCheap) {
    QImage image(1080, 1920, QImage::Format_RGB32);
    image.fill(Qt::darkGray);
    const ImagePyramid pyramid(image);
    for (CameraView* view : grid.views()) {
        view->setImage(pyramid);
        std::vector<ViewMark> marks(28);
        for (std::size_t i = 0; i < marks.size(); ++i) {
            marks[i].joint = {i % 2 ? core::Side::Left : core::Side::Right, "index_mcp"};
            marks[i].px = {100.0 + 30 * static_cast<double>(i), 800.0 + 5 * static_cast<double>(i)};
        }
        view->setMarks(marks);
    }
    const std::clock_t before = std::clock();
    constexpr int kRounds = 20;
    for (int i = 0; i < kRounds; ++i) {
        for (CameraView* view : grid.views()) {
            view->panBy({0.7, 0.4});
            view->viewport()->repaint();
        }
    }
    const double msPerRound = 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / kRounds;
    RecordProperty("panAllViewsMs", std::to_string(msPerRound));
    EXPECT_LT(msPerRound, 40) << "processor time to pan eight views with 28 marks each";
}

} // namespace
