// SPDX-License-Identifier: MIT
#include "widgets/views/camera/overlay_shapes_item.h"

#include <algorithm>

#include <QPaintEngine>
#include <QPainter>

namespace widgets {

namespace {

constexpr double kLineWidth = 1.2, kDotWidth = 3;
const QPointF kPixelCentre(0.5, 0.5); // from image pixels to the scene

QPen screenPen(const QColor& colour, double width, Qt::PenStyle style) {
    QPen pen(colour, width, style, Qt::RoundCap);
    pen.setCosmetic(true);
    return pen;
}

/// Dots of one size on the screen. The raster engine would stroke a circle for each: squares take a tenth of the time.
void drawDots(QPainter& painter, const OverlayShapes::Dots& dots) {
    if (painter.paintEngine()->type() != QPaintEngine::Raster) {
        painter.setPen(screenPen(dots.colour, kDotWidth, Qt::SolidLine));
        painter.drawPoints(dots.px.data(), static_cast<int>(dots.px.size()));
        return;
    }
    const QTransform deviceFromImage = painter.worldTransform();
    QVector<QRectF> squares;
    squares.reserve(static_cast<int>(dots.px.size()));
    for (const QPointF& px : dots.px)
        squares.append({deviceFromImage.map(px) - QPointF(kDotWidth, kDotWidth) / 2, QSizeF(kDotWidth, kDotWidth)});
    painter.setWorldTransform({});
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(dots.colour);
    painter.drawRects(squares);
    painter.setWorldTransform(deviceFromImage);
    painter.setRenderHint(QPainter::Antialiasing);
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
    QVector<QLineF> alike; // lines of one look in a row are drawn at once
    for (std::size_t i = 0; i < m_shapes.lines.size(); ++i) {
        const OverlayShapes::Line& line = m_shapes.lines[i];
        alike.append({line.fromPx, line.toPx});
        if (i + 1 < m_shapes.lines.size() && m_shapes.lines[i + 1].colour == line.colour &&
            m_shapes.lines[i + 1].style == line.style)
            continue;
        painter->setPen(screenPen(line.colour, kLineWidth, line.style));
        painter->drawLines(alike);
        alike.clear();
    }
    painter->restore();
}

} // namespace widgets
