// SPDX-License-Identifier: MIT
#include "widgets/panels/mark_legend.h"

#include <algorithm>

#include <QPainter>

#include "widgets/panels/state_colours.h"
#include "widgets/views/camera/mark_item.h"

namespace widgets {

namespace {

constexpr int kGlyphWidth = 34;
constexpr int kLeastRow = 22;

ViewMark example(MarkOrigin origin, bool occluded = false, bool outlier = false) {
    ViewMark mark;
    mark.joint = {core::Side::Left, "index_mcp"};
    mark.origin = origin;
    mark.occluded = occluded;
    mark.outlier = outlier;
    return mark;
}

} // namespace

MarkLegend::MarkLegend(QWidget* parent)
    : QWidget(parent)
    , m_rows{{example(MarkOrigin::Manual), tr("clicked: the 3D joint follows from these")},
             {example(MarkOrigin::Auto), tr("accepted as it was placed for you")},
             {example(MarkOrigin::Proposed), tr("proposed: not a label until it is accepted")},
             {example(MarkOrigin::Manual, true), tr("occluded, estimated")},
             {example(MarkOrigin::Manual, false, true), tr("contradicts the other views")}} {
    ViewMark right = example(MarkOrigin::Manual);
    right.joint.hand = core::Side::Right;
    m_rows.push_back({right, tr("square: right hand; round: left hand")});
    setAccessibleName(tr("What the marks mean"));
}

int MarkLegend::rowHeight() const {
    return std::max(kLeastRow, fontMetrics().height() + 2);
}

QSize MarkLegend::sizeHint() const {
    int widest = 0;
    for (const Row& row : m_rows)
        widest = std::max(widest, fontMetrics().horizontalAdvance(row.text));
    return {kGlyphWidth + widest + kSpacing, rowHeight() * static_cast<int>(m_rows.size())};
}

QSize MarkLegend::minimumSizeHint() const {
    return {kGlyphWidth + 100, sizeHint().height()};
}

void MarkLegend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    double top = 0;
    for (const Row& row : m_rows) {
        painter.save();
        painter.translate(kGlyphWidth / 2.0, top + rowHeight() / 2.0);
        MarkItem item(nullptr);
        item.setMark(row.mark);
        painter.setOpacity(item.opacity());
        item.paint(&painter, nullptr, nullptr);
        painter.restore();
        painter.setPen(palette().color(QPalette::WindowText));
        const QRectF place(kGlyphWidth, top, width() - kGlyphWidth, rowHeight());
        painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                         fontMetrics().elidedText(row.text, Qt::ElideRight, int(place.width())));
        top += rowHeight();
    }
}

} // namespace widgets
