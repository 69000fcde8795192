// SPDX-License-Identifier: MIT
#include "widgets/views/camera/wipe_cover.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

namespace widgets {

namespace {

constexpr int kWipeReachPx = 6; ///< pixels to the right of the line in which it is grabbed
constexpr int kWipeLinePx = 2;
constexpr int kNamePadding = 6, kNameChipPx = 8;

} // namespace

WipeCover::WipeCover(CameraView& over, const CameraView& other)
    : QWidget(over.viewport())
    , m_area(over.viewport())
    , m_other(&other) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true); // the view below sees the pointer through this
    m_area->installEventFilter(this);
    other.viewport()->installEventFilter(this);
    layOut();
    show();
}

int WipeCover::line() const {
    return static_cast<int>(std::lround(m_place * m_area->width()));
}

void WipeCover::setPlace(double share) {
    m_place = std::clamp(share, 0.0, 1.0);
    layOut();
}

void WipeCover::layOut() {
    const int x = line();
    setGeometry(x, 0, std::max(0, m_area->width() - x), m_area->height());
    setVisible(m_place < 1);
    update();
}

/// Follows the size of the view below and whatever the other one draws.
bool WipeCover::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_area && event->type() == QEvent::Resize)
        layOut();
    else if (watched != m_area && event->type() == QEvent::Paint && !m_grabbing)
        update();
    return QWidget::eventFilter(watched, event);
}

void WipeCover::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!m_other) {
        painter.fillRect(rect(), palette().color(QPalette::Window));
        return;
    }
    m_grabbing = true; // makes the other view paint itself, which would ask for this again
    painter.drawPixmap(QPointF(0, 0), m_other->viewport()->grab(QRect(QPoint(x(), 0), size())));
    m_grabbing = false;
    if (m_place > 0)
        painter.fillRect(QRect(0, 0, kWipeLinePx, height()), palette().color(QPalette::Highlight));
    paintName(painter);
}

/// Whose picture this is: the title above names the one below.
void WipeCover::paintName(QPainter& painter) const {
    const ViewTitle& title = m_other->title();
    const QFontMetrics metrics = fontMetrics();
    const int line = metrics.height(), left = m_place > 0 ? kWipeLinePx : 0;
    const QString name =
        metrics.elidedText(title.name, Qt::ElideMiddle, width() - left - 3 * kNamePadding - kNameChipPx);
    const QRect box(left, 0, metrics.horizontalAdvance(name) + 3 * kNamePadding + kNameChipPx, line + 2);
    painter.fillRect(box, palette().color(QPalette::Window));
    painter.fillRect(QRect(left + kNamePadding, (box.height() - kNameChipPx) / 2, kNameChipPx, kNameChipPx),
                     title.colour);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(box.adjusted(2 * kNamePadding + kNameChipPx, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, name);
}

void WipeCover::mousePressEvent(QMouseEvent* event) {
    m_dragging = event->button() == Qt::LeftButton && m_place > 0 && event->pos().x() <= kWipeReachPx;
    event->setAccepted(m_dragging);
}

void WipeCover::mouseMoveEvent(QMouseEvent* event) {
    event->setAccepted(m_dragging);
    setCursor(m_dragging || (m_place > 0 && event->pos().x() <= kWipeReachPx) ? QCursor(Qt::SplitHCursor)
                                                                              : m_area->cursor());
    if (m_dragging)
        emit dragged(
            std::clamp(static_cast<double>(mapToParent(event->pos()).x()) / std::max(1, m_area->width()), 0.02, 0.98));
}

void WipeCover::mouseReleaseEvent(QMouseEvent* event) {
    event->setAccepted(m_dragging);
    m_dragging = false;
}

} // namespace widgets
