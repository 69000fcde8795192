// SPDX-License-Identifier: MIT
#include "widgets/views/camera/mark_item.h"

#include <algorithm>

#include <QApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPixmapCache>
#include <QWidget>

#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

// All in screen pixels.
constexpr double kRadius = 4.5; // of the ring's line; with its width the ring measures 11
constexpr double kLineWidth = 2;
constexpr double kAcceptedWidth = 1.6;
constexpr double kBadgeRadius = 2;
constexpr double kOutline = 1; // dark, on both sides of the line
constexpr double kHaloRadius = 8;
constexpr double kCrossReach = 19;
constexpr double kLabelOffset = 10;
constexpr int kGlyphReach = 22; // from the centre to the edge of its picture
const QColor kDark(0, 0, 0, 200);
const QColor kOutlierRed(0xFF, 0x3B, 0x30);

void drawRing(QPainter& painter, core::Side hand, double radius) {
    const QRectF box(-radius, -radius, 2 * radius, 2 * radius);
    if (hand == core::Side::Left)
        painter.drawEllipse(box);
    else
        painter.drawRect(box);
}

/// Draws with the dark outline first, then in `colour`.
template <typename Draw>
void drawOutlined(QPainter& painter, QPen pen, Draw&& draw) {
    QPen dark(kDark, pen.widthF() + 2 * kOutline);
    dark.setCapStyle(pen.capStyle());
    dark.setJoinStyle(Qt::MiterJoin);
    painter.setPen(dark);
    draw();
    pen.setJoinStyle(Qt::MiterJoin);
    painter.setPen(pen);
    draw();
}

QPen ringPen(const ViewMark& mark) {
    QPen pen(fingerColour(mark.joint.joint),
             mark.origin == MarkOrigin::Auto && !mark.occluded ? kAcceptedWidth : kLineWidth);
    pen.setCapStyle(Qt::FlatCap);
    if (mark.occluded)
        pen.setDashPattern({0.7, 0.85}); // dotted, in units of the width
    else if (mark.origin == MarkOrigin::Proposed)
        pen.setDashPattern({1.9, 1.35});
    return pen;
}

/// A dot at the ring's upper right corner: this mark was accepted, not clicked.
void drawBadge(QPainter& painter, const QColor& colour) {
    const QPointF corner(kRadius + 1, -kRadius - 1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kDark);
    painter.drawEllipse(corner, kBadgeRadius + kOutline, kBadgeRadius + kOutline);
    painter.setBrush(colour);
    painter.drawEllipse(corner, kBadgeRadius, kBadgeRadius);
    painter.setBrush(Qt::NoBrush);
}

void drawSelection(QPainter& painter, core::Side hand) {
    drawOutlined(painter, QPen(QColor(255, 255, 255, 235), 1.2), [&] { drawRing(painter, hand, kHaloRadius); });
    QPen line(Qt::white, 1);
    line.setCapStyle(Qt::FlatCap);
    drawOutlined(painter, line, [&] {
        for (const QPointF d : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(d * (kHaloRadius + 1), d * kCrossReach);
    });
}

void drawOutlierCross(QPainter& painter) {
    constexpr double kInner = 2.6, kOuter = 7.5; // through the ring, but not over the pixel that it marks
    QPen pen(kOutlierRed, 2);
    pen.setCapStyle(Qt::FlatCap);
    drawOutlined(painter, pen, [&] {
        for (const QPointF d : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)})
            painter.drawLine(d * kInner * M_SQRT1_2, d * kOuter);
    });
}

} // namespace

MarkItem::MarkItem(QGraphicsItem* parent)
    : QGraphicsItem(parent) {
    setFlag(ItemIgnoresTransformations);
}

void MarkItem::setMark(const ViewMark& mark) {
    prepareGeometryChange();
    m_mark = mark;
    setPos(mark.px + QPointF(0.5, 0.5));
    setZValue(mark.selected ? 2 : (mark.origin == MarkOrigin::Proposed ? 0 : 1));
    setOpacity(mark.origin == MarkOrigin::Proposed && !mark.selected ? 0.7 : 1);
    update();
}

void MarkItem::setLabelShown(bool shown) {
    prepareGeometryChange();
    m_labelShown = shown;
}

/// Below the mark to the right; `leftwards` and `upwards` where there is no room.
QRectF MarkItem::labelRect(bool leftwards, bool upwards) const {
    const QFontMetricsF metrics(QApplication::font());
    const QSizeF size(metrics.horizontalAdvance(m_mark.label) + 8, metrics.height() + 2);
    return {QPointF(leftwards ? -kLabelOffset - size.width() : kLabelOffset,
                    upwards ? -kLabelOffset - size.height() : kLabelOffset),
            size};
}

QRectF MarkItem::labelRectIn(const QPainter& painter, const QWidget* widget) const {
    if (!widget)
        return labelRect(false, false);
    const QRectF box = painter.worldTransform().mapRect(labelRect(false, false));
    return labelRect(box.right() > widget->width(), box.bottom() > widget->height());
}

QRectF MarkItem::boundingRect() const {
    const double reach = m_mark.selected ? kCrossReach + 2 : 11;
    const QRectF ring(-reach, -reach, 2 * reach, 2 * reach);
    return hasLabel() ? ring.united(labelRect(false, false)).united(labelRect(true, true)) : ring;
}

/// The mark without its label, around the origin.
void MarkItem::drawGlyph(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (m_mark.selected)
        drawSelection(painter, m_mark.joint.hand);
    drawOutlined(painter, ringPen(m_mark), [&] { drawRing(painter, m_mark.joint.hand, kRadius); });
    if (m_mark.origin == MarkOrigin::Auto)
        drawBadge(painter, fingerColour(m_mark.joint.joint));
    if (m_mark.occluded) {
        QPen bar(fingerColour(m_mark.joint.joint), kLineWidth);
        bar.setCapStyle(Qt::FlatCap);
        drawOutlined(painter, bar, [&] { painter.drawLine(QPointF(-5.5, 8.5), QPointF(5.5, 8.5)); });
    }
    if (m_mark.outlier)
        drawOutlierCross(painter);
}

/// The glyph as a picture: of the few dozen kinds of marks, each is drawn once and then only copied.
QPixmap MarkItem::glyph(double pixelRatio) const {
    const QColor colour = fingerColour(m_mark.joint.joint);
    const QString key = QStringLiteral("handlens-mark %1 %2 %3 %4 %5 %6")
                            .arg(colour.rgba())
                            .arg(m_mark.joint.hand == core::Side::Left)
                            .arg(static_cast<int>(m_mark.origin))
                            .arg(m_mark.occluded)
                            .arg(m_mark.outlier)
                            .arg(pixelRatio);
    QPixmap picture;
    if (!QPixmapCache::find(key, &picture)) {
        picture = QPixmap((QSizeF(2 * kGlyphReach, 2 * kGlyphReach) * pixelRatio).toSize());
        picture.setDevicePixelRatio(pixelRatio);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.translate(kGlyphReach, kGlyphReach);
        drawGlyph(painter);
        painter.end();
        QPixmapCache::insert(key, picture);
    }
    return picture;
}

void MarkItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) {
    // Pictures lie on whole pixels; the selected mark and saved pictures are exact.
    if (widget && !m_mark.selected)
        painter->drawPixmap(QPointF(-kGlyphReach, -kGlyphReach), glyph(widget->devicePixelRatioF()));
    else
        drawGlyph(*painter);
    if (hasLabel()) {
        const QRectF box = labelRectIn(*painter, widget);
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(QColor(0, 0, 0, 170));
        painter->drawRoundedRect(box, 3, 3);
        painter->setPen(Qt::white);
        painter->setFont(QApplication::font());
        painter->drawText(box, Qt::AlignCenter, m_mark.label);
    }
}

} // namespace widgets
