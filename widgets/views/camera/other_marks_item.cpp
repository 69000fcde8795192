// SPDX-License-Identifier: MIT
#include "widgets/views/camera/other_marks_item.h"

#include <algorithm>

#include <QApplication>
#include <QPainter>

#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

const QPointF kHalf(0.5, 0.5);  // from image pixels to the scene
constexpr double kRadius = 3.5; // screen px
constexpr double kNameOffset = 6;
constexpr double kOpacity = 0.75;

/// The finger's colour, greyed.
QColor muted(const QColor& colour) {
    return QColor::fromHsvF(std::max(0.0, colour.hsvHueF()), 0.35 * colour.hsvSaturationF(), 0.8);
}

void drawRing(QPainter& painter, core::Side hand) {
    const QRectF box(-kRadius, -kRadius, 2 * kRadius, 2 * kRadius);
    if (hand == core::Side::Left)
        painter.drawEllipse(box);
    else
        painter.drawRect(box);
}

} // namespace

void OtherMarksItem::setMarks(const std::vector<ViewMark>& marks) {
    if (marks == m_marks)
        return;
    m_marks = marks;
    QRectF bounds;
    for (const ViewMark& mark : marks) {
        const QRectF place(mark.px, QSizeF(1e-6, 1e-6));
        bounds = bounds.isNull() ? place : bounds.united(place);
    }
    setBounds(bounds);
}

void OtherMarksItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setOpacity(kOpacity);
    painter->setBrush(Qt::NoBrush);
    painter->setFont(QApplication::font());
    const double scale = painter->transform().m11() > 0 ? painter->transform().m11() : 1;
    for (const ViewMark& mark : m_marks) {
        painter->save();
        painter->translate(mark.px + kHalf);
        painter->scale(1 / scale, 1 / scale);
        for (const auto& [colour, width] :
             {std::pair(QColor(0, 0, 0, 170), 2.8), std::pair(muted(fingerColour(mark.joint.joint)), 1.2)}) {
            painter->setPen(QPen(colour, width));
            drawRing(*painter, mark.joint.hand);
        }
        if (mark.named)
            painter->drawText(QPointF(kNameOffset, -kNameOffset), mark.label);
        painter->restore();
    }
}

} // namespace widgets
