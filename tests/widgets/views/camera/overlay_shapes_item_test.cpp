// SPDX-License-Identifier: MIT
#include "widgets/views/camera/overlay_shapes_item.h"

#include <cmath>
#include <random>

#include <QImage>
#include <QPainter>

#include <gtest/gtest.h>

namespace {

using namespace widgets;

const QColor kGround(20, 30, 40), kDot(200, 100, 50);

/// Drawn into a picture of that many device pixels a point, through a view's transform.
QImage drawn(const OverlayShapes& shapes, const QTransform& screenFromImage, double density) {
    OverlayShapesItem item(nullptr);
    item.setShapes(shapes);
    QImage picture(QSize(120, 90) * density, QImage::Format_RGB32);
    picture.setDevicePixelRatio(density);
    picture.fill(kGround);
    QPainter painter(&picture);
    painter.setWorldTransform(screenFromImage);
    item.paint(&painter, nullptr, nullptr);
    painter.end();
    picture.setDevicePixelRatio(1);
    return picture;
}

class OverlayDots : public testing::TestWithParam<double> {};

TEST_P(OverlayDots, CoverThePixelsWhoseCentresLieInTheirSquares) {
    const double density = GetParam();
    QTransform screenFromImage;
    screenFromImage.translate(3.25, -7.5);
    screenFromImage.scale(0.37, 0.37);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-40, 380), y(-40, 300);
    OverlayShapes shapes;
    shapes.dots.resize(1);
    shapes.dots[0].colour = kDot;
    for (int i = 0; i < 80; ++i)
        shapes.dots[0].px.emplace_back(x(random), y(random));
    const QImage picture = drawn(shapes, screenFromImage, density);
    int covered = 0;
    for (int row = 0; row < picture.height(); ++row) {
        for (int column = 0; column < picture.width(); ++column) {
            bool isCovered = false;
            for (const QPointF& px : shapes.dots[0].px) {
                const QPointF middle = screenFromImage.map(px + QPointF(0.5, 0.5)) * density;
                const QPointF off = QPointF(column + 0.5, row + 0.5) - middle;
                isCovered = isCovered || (std::abs(off.x()) < 1.5 * density && std::abs(off.y()) < 1.5 * density);
            }
            covered += isCovered ? 1 : 0;
            ASSERT_EQ(picture.pixelColor(column, row), isCovered ? kDot : kGround) << column << ", " << row;
        }
    }
    EXPECT_GT(covered, 200);
}

INSTANTIATE_TEST_SUITE_P(PixelsPerPoint, OverlayDots, testing::Values(1.0, 1.5, 2.0));

/// What lies beside the picture is left out; what reaches into it is not, however far away its ends are.
TEST(OverlayLines, AreDrawnWhereverTheyCrossThePicture) {
    const QTransform screenFromImage = QTransform::fromScale(2, 2);
    const auto inkOf = [&](QPointF from, QPointF to) {
        OverlayShapes shapes;
        shapes.lines.push_back({from, to, kDot});
        const QImage picture = drawn(shapes, screenFromImage, 1);
        int ink = 0;
        for (int row = 0; row < picture.height(); ++row)
            for (int column = 0; column < picture.width(); ++column)
                ink += picture.pixelColor(column, row) != kGround ? 1 : 0;
        return ink;
    };
    EXPECT_GT(inkOf({-1000, 20}, {1000, 20}), 100) << "flat, both ends outside";
    EXPECT_GT(inkOf({30, -500}, {30, 500}), 80) << "upright, both ends outside";
    EXPECT_GT(inkOf({-10, 20}, {20, -10}), 10) << "over a corner";
    EXPECT_EQ(inkOf({-300, -10}, {300, -10}), 0);
    EXPECT_GT(inkOf({0, -0.6}, {40, -0.6}), 20) << "half of its width is inside";
}

} // namespace
