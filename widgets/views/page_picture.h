// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QColor>
#include <QImage>
#include <QRectF>
#include <QString>

class QPainter;

namespace widgets {

/// A page that is put together from parts, to be saved as pixels or as vectors.
struct PagePicture {
    struct Part {
        QRectF place;
        /// Draws the part with its top left corner at (0, 0); what goes beyond its size is cut off. `pictureScale`
        /// pixels per unit are enough for embedded pictures.
        std::function<void(QPainter&, double pictureScale)> paint;
    };
    QString title;
    QSizeF size; ///< in logical pixels
    QColor ground = Qt::white;
    std::vector<Part> parts; ///< the later ones lie over the earlier ones
};

QImage pageImage(const PagePicture& page, double scale);
/// Every part is a drawing of its own within the page's. False if the file cannot be written.
bool savePageSvg(const PagePicture& page, const QString& path);
bool savePagePdf(const PagePicture& page, const QString& path);

} // namespace widgets
