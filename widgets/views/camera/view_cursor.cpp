// SPDX-License-Identifier: MIT
#include "widgets/views/camera/view_cursor.h"

#include <QPainter>
#include <QPixmap>

namespace widgets {

QCursor placingCursor() {
    constexpr int kSide = 25, kMiddle = 12, kGap = 4;
    QPixmap picture(kSide, kSide);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    const auto drawArms = [&](const QColor& colour, int width) {
        const int half = width / 2;
        for (const QRect& arm : {QRect(0, kMiddle - half, kMiddle - kGap, width),
                                 QRect(kMiddle + kGap + 1, kMiddle - half, kSide - kMiddle - kGap - 1, width),
                                 QRect(kMiddle - half, 0, width, kMiddle - kGap),
                                 QRect(kMiddle - half, kMiddle + kGap + 1, width, kSide - kMiddle - kGap - 1)})
            painter.fillRect(arm, colour);
    };
    drawArms(QColor(0, 0, 0, 170), 3);
    drawArms(Qt::white, 1);
    painter.end();
    return QCursor(picture, kMiddle, kMiddle);
}

} // namespace widgets
