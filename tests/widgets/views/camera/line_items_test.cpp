// SPDX-License-Identifier: MIT
#include "widgets/views/camera/line_items.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "widgets/views/camera/camera_view.h"

namespace {

using namespace widgets;

class LineItemsTest : public testing::Test {
protected:
    LineItemsTest() {
        view.setCamera(test::cameraRing(1)[0]);
        view.resize(400, 420);
        view.show();
        QImage image(1080, 1920, QImage::Format_RGB32);
        image.fill(Qt::black);
        view.setImage(image);
        view.lookAt({500, 700}, 1);
    }
    int brightness(QPointF px) {
        const QImage image = view.viewport()->grab().toImage();
        const QPoint centre = view.imageToViewport(px).toPoint();
        int best = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                best = std::max(best, image.pixelColor(centre + QPoint(dx, dy)).value());
        return best;
    }
    /// Lit screen pixels in the column of this image pixel.
    int litInColumn(double x) {
        const QImage image = view.viewport()->grab().toImage();
        const int column = view.imageToViewport({x, 700}).toPoint().x();
        int lit = 0;
        for (int y = 0; y < image.height(); ++y)
            lit += image.pixelColor(column, y).value() > 40;
        return lit;
    }
    CameraView view;
};

TEST_F(LineItemsTest, BonesAreThinAtEveryZoom) {
    view.setSkeleton({{{400, 700}, {600, 700}, Qt::white}});
    for (const double scale : {0.5, 1.0, 15.0}) {
        view.lookAt({500, 700}, scale);
        EXPECT_GT(brightness({500, 700}), 120) << scale;
        EXPECT_GE(litInColumn(500), 1) << scale;
        EXPECT_LE(litInColumn(500), 3) << scale;
    }
    view.lookAt({500, 700}, 1);
    EXPECT_EQ(brightness({620, 700}), 0);
}

TEST_F(LineItemsTest, GuidesFadeAwayFromTheFocus) {
    std::vector<QPointF> points;
    for (int x = 320; x <= 680; x += 10)
        points.emplace_back(x, 700);
    view.setEpipolarGuides({{points, Qt::white}});
    view.setGuideFocus(QPointF(340, 700));
    const int nearFocus = brightness({345, 700}), farAway = brightness({670, 700});
    EXPECT_GT(nearFocus, 2 * farAway);
    EXPECT_GT(farAway, 20) << "still there";
    view.setGuideFocus(QPointF(660, 700));
    EXPECT_GT(brightness({670, 700}), brightness({345, 700}));
}

TEST_F(LineItemsTest, EllipseLiesWhereItsAxesSay) {
    UncertaintyEllipse ellipse{{500, 700}, 80, 30, 0.6, Qt::white};
    view.setEllipse(ellipse);
    const QPointF a(std::cos(0.6), std::sin(0.6)), b(-std::sin(0.6), std::cos(0.6));
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_GT(brightness(ellipse.centrePx + sign * 80 * a), 100);
        EXPECT_GT(brightness(ellipse.centrePx + sign * 30 * b), 100);
        EXPECT_EQ(brightness(ellipse.centrePx + sign * 88 * a), 0);
        EXPECT_EQ(brightness(ellipse.centrePx + sign * 38 * b), 0);
    }
    view.setEllipse(std::nullopt);
    EXPECT_EQ(brightness(ellipse.centrePx + 80 * a), 0);
}

TEST_F(LineItemsTest, ReprojectionLinesCanBeExaggerated) {
    ViewMark mark;
    mark.joint = {core::Side::Left, "middle_pip"};
    mark.px = {450, 700};
    mark.reprojectionPx = QPointF(480, 700);
    view.setMarks({mark});
    EXPECT_GT(brightness({475, 700}), 60);
    EXPECT_EQ(brightness({525, 700}), 0);
    view.setReprojectionScale(3);
    EXPECT_GT(brightness({525, 700}), 60);
    EXPECT_EQ(brightness({548, 700}), 0);
    mark.origin = MarkOrigin::Proposed;
    view.setMarks({mark});
    EXPECT_EQ(brightness({525, 700}), 0) << "a proposal is its own reprojection";
}

} // namespace
