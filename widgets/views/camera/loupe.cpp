// SPDX-License-Identifier: MIT
#include "widgets/views/camera/loupe.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

namespace widgets {

namespace {

constexpr int kSide = 148;
constexpr int kDistance = 22; // from the pointer to the loupe, so that the pointer's own surroundings stay visible
constexpr double kLeastScale = 8;

} // namespace

Loupe::Loupe(QWidget* parent)
    : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    resize(kSide, kSide);
    hide();
}

void Loupe::show(const ImagePyramid& image, const ImageAdjustment& adjustment, QPointF px, QPointF pointer,
                 double viewScale) {
    m_image = image;
    m_adjustment = adjustment;
    m_px = px;
    m_scale = std::max(kLeastScale, 3 * viewScale);
    QPoint place = (pointer + QPointF(kDistance, -kDistance - kSide)).toPoint();
    const QRect room = parentWidget()->rect();
    if (place.x() + kSide > room.right())
        place.setX(static_cast<int>(pointer.x()) - kDistance - kSide);
    if (place.y() < room.top())
        place.setY(static_cast<int>(pointer.y()) + kDistance);
    place.setX(std::clamp(place.x(), 0, std::max(0, room.width() - kSide)));
    place.setY(std::clamp(place.y(), 0, std::max(0, room.height() - kSide)));
    move(place);
    QWidget::show();
    update();
}

void Loupe::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0x10, 0x11, 0x13));
    const QPointF middle(kSide / 2.0, kSide / 2.0);
    if (!m_image.isNull()) {
        // Of a draft, a pixel is as large as several. Pixel i covers i - 0.5 .. i + 0.5.
        const double side = 1 << m_image.firstLevel(), scale = m_scale * side;
        const QPointF px = (m_px + QPointF(0.5, 0.5)) / side - QPointF(0.5, 0.5);
        const int reach = static_cast<int>(std::ceil(kSide / 2.0 / scale)) + 1;
        const QPoint pixel(qRound(px.x()), qRound(px.y()));
        const QRect source = QRect(pixel - QPoint(reach, reach), pixel + QPoint(reach, reach)) & m_image.image().rect();
        const QImage piece = adjusted(m_image.image().copy(source), m_adjustment);
        const QPointF topLeft = middle + (QPointF(source.topLeft()) - QPointF(0.5, 0.5) - px) * scale;
        painter.drawImage(QRectF(topLeft, QSizeF(source.size()) * scale), piece);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kGap = 7;
    for (const auto& [colour, width] :
         {std::pair(QColor(0, 0, 0, 150), 3.0), std::pair(QColor(255, 255, 255, 230), 1.0)}) {
        painter.setPen(QPen(colour, width));
        for (const QPointF direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(middle + direction * kGap, middle + direction * (kSide / 2.0));
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace widgets
