// SPDX-License-Identifier: MIT
#include "widgets/views/camera/hand_label_item.h"

#include <QApplication>
#include <QFont>
#include <QPainter>

namespace widgets {

namespace {

constexpr double kSide = 18;  // screen pixels
constexpr double kLevel = -1; // under the marks, over the lines
const QPointF kHalfPixel(0.5, 0.5);

} // namespace

HandLabelItem::HandLabelItem(QGraphicsItem* parent)
    : QGraphicsItem(parent) {
    setFlag(ItemIgnoresTransformations);
    setZValue(kLevel);
}

void HandLabelItem::setLabel(const HandLabel& label) {
    prepareGeometryChange();
    m_label = label;
    setPos(label.px + kHalfPixel);
    update();
}

QRectF HandLabelItem::box() const {
    return QRectF(-kSide / 2, -kSide / 2, kSide, kSide).translated(m_label.awayScreenPx);
}

QRectF HandLabelItem::boundingRect() const {
    return box().adjusted(-1, -1, 1, 1);
}

void HandLabelItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(QColor(255, 255, 255, 210), 1.2));
    painter->setBrush(QColor(0, 0, 0, 170));
    if (m_label.side == core::Side::Left)
        painter->drawEllipse(box());
    else
        painter->drawRect(box());
    QFont font = QApplication::font();
    font.setPixelSize(12);
    font.setBold(true);
    painter->setFont(font);
    painter->setPen(Qt::white);
    painter->drawText(box(), Qt::AlignCenter, m_label.text);
}

} // namespace widgets
