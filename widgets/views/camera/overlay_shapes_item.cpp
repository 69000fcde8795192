// SPDX-License-Identifier: MIT
#include "widgets/views/camera/overlay_shapes_item.h"

#include <algorithm>

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

/// The bounds of points, grown one by one.
struct Bounds {
    QRectF rect;
    void add(QPointF px) {
        const QRectF point(px, QSizeF(1e-6, 1e-6));
        rect = rect.isNull() ? point : rect.united(point);
    }
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
    setBounds(bounds.rect);
}

void OverlayShapesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    painter->save();
    painter->translate(kPixelCentre);
    for (const OverlayShapes::Dots& dots : m_shapes.dots) {
        painter->setPen(screenPen(dots.colour, kDotWidth, Qt::SolidLine));
        painter->drawPoints(dots.px.data(), static_cast<int>(dots.px.size()));
    }
    for (const OverlayShapes::Line& line : m_shapes.lines) {
        painter->setPen(screenPen(line.colour, kLineWidth, line.dashed ? Qt::DashLine : Qt::SolidLine));
        painter->drawLine(line.fromPx, line.toPx);
    }
    painter->restore();
}

} // namespace widgets
