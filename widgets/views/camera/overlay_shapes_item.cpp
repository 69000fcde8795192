// SPDX-License-Identifier: MIT
#include "widgets/views/camera/overlay_shapes_item.h"

#include <algorithm>
#include <cmath>

#include <QPaintEngine>
#include <QPainter>

namespace widgets {

namespace {

constexpr double kLineWidth = 1.2, kDotWidth = 3;
const QPointF kPixelCentre(0.5, 0.5); // from image pixels to the scene

/// With square ends: the raster engine fills such lines at once, and strokes the outline of one with round ends.
QPen screenPen(const QColor& colour, double width, Qt::PenStyle style) {
    QPen pen(colour, width, style, Qt::SquareCap);
    pen.setCosmetic(true);
    return pen;
}

/// The pixels whose centres lie in the square of a dot, on the device.
QRect dotPixels(QPointF middle, double side) {
    const auto first = [](double edge) { return static_cast<int>(std::ceil(edge - 0.5)); };
    const QPoint topLeft(first(middle.x() - side / 2), first(middle.y() - side / 2));
    return {topLeft, QPoint(first(middle.x() + side / 2), first(middle.y() + side / 2)) - QPoint(1, 1)};
}

/// Dots of one size on the screen. The raster engine would stroke a circle for each; it copies whole pixels in a
/// hundredth of the time. Dots beside each other on a contour often have the same ones.
void drawDots(QPainter& painter, const OverlayShapes::Dots& dots) {
    if (painter.paintEngine()->type() != QPaintEngine::Raster) {
        painter.setPen(screenPen(dots.colour, kDotWidth, Qt::SolidLine));
        painter.drawPoints(dots.px.data(), static_cast<int>(dots.px.size()));
        return;
    }
    const QTransform sceneTransform = painter.worldTransform(), deviceFromImage = painter.deviceTransform();
    painter.setWorldTransform({});
    const QTransform deviceFromPoint =
        painter.deviceTransform(); // scaled on dense screens, moved to the widget's place
    const double side = kDotWidth * deviceFromPoint.m11();
    const QRect device(0, 0, painter.device()->width() + 1, painter.device()->height() + 1);
    const QRect visible = deviceFromPoint.mapRect(device).adjusted(-1, -1, 1, 1);
    QVector<QRect> squares;
    squares.reserve(static_cast<int>(dots.px.size()));
    for (const QPointF& px : dots.px) {
        const QRect square = dotPixels(deviceFromImage.map(px), side);
        if (visible.intersects(square) && (squares.isEmpty() || squares.back() != square))
            squares.append(square);
    }
    painter.setWorldTransform(deviceFromPoint.inverted());
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(dots.colour);
    painter.drawRects(squares);
    painter.setWorldTransform(sceneTransform);
    painter.setRenderHint(QPainter::Antialiasing);
}

/// What of the shapes' coordinates is on the device, with room for a line's width; everything for devices of pages.
QRectF visibleArea(const QPainter& painter) {
    if (painter.paintEngine()->type() != QPaintEngine::Raster)
        return {QPointF(-1e9, -1e9), QPointF(1e9, 1e9)};
    constexpr double kRoom = 4;
    const QRectF device(0, 0, painter.device()->width(), painter.device()->height());
    return painter.worldTransform().inverted().mapRect(device.adjusted(-kRoom, -kRoom, kRoom, kRoom));
}

/// Whether the bounds of the line, which may be flat, touch the area.
bool reaches(const OverlayShapes::Line& line, const QRectF& area) {
    return std::max(line.fromPx.x(), line.toPx.x()) >= area.left() &&
           std::min(line.fromPx.x(), line.toPx.x()) <= area.right() &&
           std::max(line.fromPx.y(), line.toPx.y()) >= area.top() &&
           std::min(line.fromPx.y(), line.toPx.y()) <= area.bottom();
}

/// The bounds of points, grown one by one; null without any.
struct Bounds {
    QPointF low{1e18, 1e18}, high{-1e18, -1e18};
    void add(QPointF px) {
        low = {std::min(low.x(), px.x()), std::min(low.y(), px.y())};
        high = {std::max(high.x(), px.x()), std::max(high.y(), px.y())};
    }
    QRectF rect() const { return low.x() > high.x() ? QRectF() : QRectF(low, high).adjusted(0, 0, 1e-6, 1e-6); }
};

} // namespace

void OverlayShapesItem::setShapes(OverlayShapes shapes) {
    m_shapes = std::move(shapes);
    Bounds bounds;
    for (const OverlayShapes::Line& line : m_shapes.lines) {
        bounds.add(line.fromPx);
        bounds.add(line.toPx);
    }
    for (const OverlayShapes::Dots& dots : m_shapes.dots)
        for (const QPointF& px : dots.px)
            bounds.add(px);
    setBounds(bounds.rect());
}

void OverlayShapesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    painter->save();
    painter->translate(kPixelCentre);
    for (const OverlayShapes::Dots& dots : m_shapes.dots)
        drawDots(*painter, dots);
    const QRectF visible = visibleArea(*painter);
    QVector<QLineF> alike; // lines of one look in a row are drawn at once
    for (std::size_t i = 0; i < m_shapes.lines.size(); ++i) {
        const OverlayShapes::Line& line = m_shapes.lines[i];
        if (reaches(line, visible))
            alike.append({line.fromPx, line.toPx});
        if (i + 1 < m_shapes.lines.size() && m_shapes.lines[i + 1].colour == line.colour &&
            m_shapes.lines[i + 1].style == line.style)
            continue;
        if (alike.isEmpty())
            continue;
        painter->setPen(screenPen(line.colour, kLineWidth, line.style));
        painter->drawLines(alike);
        alike.clear();
    }
    painter->restore();
}

} // namespace widgets
