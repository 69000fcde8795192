// SPDX-License-Identifier: MIT
#pragma once

#include <QGraphicsItem>

#include "widgets/views/camera/view_mark.h"

namespace widgets {

/// One joint's mark: the same size on the screen at every zoom, its centre always open.
/// Round for the left hand, square for the right one; colour by finger; see MarkOrigin and ViewMark for its states.
class MarkItem : public QGraphicsItem {
public:
    explicit MarkItem(QGraphicsItem* parent);

    void setMark(const ViewMark& mark);
    const ViewMark& mark() const { return m_mark; }
    void setLabelShown(bool shown);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void drawGlyph(QPainter& painter) const;
    QPixmap glyph(double pixelRatio) const;
    bool hasLabel() const { return !m_mark.label.isEmpty() && (m_labelShown || m_mark.named); }
    QRectF labelRect(bool leftwards, bool upwards) const;
    QRectF labelRectIn(const QPainter& painter, const QWidget* widget) const;

    ViewMark m_mark;
    bool m_labelShown = false;
};

} // namespace widgets
