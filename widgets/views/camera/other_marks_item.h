// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "widgets/views/camera/line_items.h"

namespace widgets {

/// Marks of other people: small thin rings (left hand) and squares (right hand) in muted colours, the same size on the
/// screen at every zoom. The selected joint's says whose it is.
class OtherMarksItem : public LineItem {
public:
    using LineItem::LineItem;
    void setMarks(const std::vector<ViewMark>& marks);
    const std::vector<ViewMark>& marks() const { return m_marks; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    std::vector<ViewMark> m_marks;
};

} // namespace widgets
