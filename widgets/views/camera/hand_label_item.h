// SPDX-License-Identifier: MIT
#pragma once

#include <QGraphicsItem>

#include "widgets/views/camera/view_mark.h"

namespace widgets {

/// The letter beside a hand that says which one it is: in a circle for the left hand, in a square for the right one, as
/// the marks are. The same size on the screen at every zoom.
class HandLabelItem : public QGraphicsItem {
public:
    explicit HandLabelItem(QGraphicsItem* parent);

    void setLabel(const HandLabel& label);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    QRectF box() const;

    HandLabel m_label;
};

} // namespace widgets
