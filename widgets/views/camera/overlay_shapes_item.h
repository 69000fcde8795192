// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/views/camera/line_items.h"

namespace widgets {

/// Matches, rims and contours of an inspected method: lines 1.2 and dots 3 screen pixels wide.
class OverlayShapesItem : public LineItem {
public:
    using LineItem::LineItem;
    void setShapes(OverlayShapes shapes);
    const OverlayShapes& shapes() const { return m_shapes; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    OverlayShapes m_shapes;
};

} // namespace widgets
