// SPDX-License-Identifier: MIT
#include "widgets/views/page_picture.h"

#include <QBuffer>
#include <QFile>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

namespace widgets {

namespace {

constexpr double kEmbeddedScale = 2; ///< of pictures within drawings
constexpr int kPixelsPerInch = 96;
constexpr double kPointsPerPixel = 72.0 / kPixelsPerInch;

void paintParts(const PagePicture& page, QPainter& painter, double pictureScale) {
    painter.fillRect(QRectF(QPointF(0, 0), page.size), page.ground);
    for (const PagePicture::Part& part : page.parts) {
        painter.save();
        painter.translate(part.place.topLeft());
        painter.setClipRect(QRectF(QPointF(0, 0), part.place.size()));
        part.paint(painter, pictureScale);
        painter.restore();
    }
}

/// An SVG that does not clip its content gets a frame of its own that does.
QByteArray partSvg(const PagePicture::Part& part) {
    QBuffer buffer;
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setResolution(kPixelsPerInch);
    svg.setSize(part.place.size().toSize());
    svg.setViewBox(QRectF(QPointF(0, 0), part.place.size()));
    QPainter painter(&svg);
    part.paint(painter, kEmbeddedScale);
    painter.end();
    QByteArray text = buffer.data();
    text.remove(0, text.indexOf("<svg"));
    const int attributesEnd = text.indexOf("viewBox");
    const QString frame = QStringLiteral("<svg x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" overflow=\"hidden\" ")
                              .arg(part.place.x())
                              .arg(part.place.y())
                              .arg(part.place.width())
                              .arg(part.place.height());
    return frame.toUtf8() + text.mid(attributesEnd);
}

} // namespace

QImage pageImage(const PagePicture& page, double scale) {
    QImage picture((page.size * scale).toSize(), QImage::Format_RGB32);
    picture.fill(page.ground); // the last row and column may be a part of a pixel more than the page
    picture.setDevicePixelRatio(scale);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintParts(page, painter, scale);
    painter.end();
    picture.setDevicePixelRatio(1);
    return picture;
}

bool savePageSvg(const PagePicture& page, const QString& path) {
    QByteArray text = QStringLiteral("<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
                                     "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                                     "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" width=\"%1\" "
                                     "height=\"%2\" viewBox=\"0 0 %1 %2\">\n<title>%3</title>\n"
                                     "<rect width=\"%1\" height=\"%2\" fill=\"%4\"/>\n")
                          .arg(page.size.width())
                          .arg(page.size.height())
                          .arg(page.title.toHtmlEscaped(), page.ground.name())
                          .toUtf8();
    for (const PagePicture::Part& part : page.parts)
        text += partSvg(part) + '\n';
    text += "</svg>\n";
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

bool savePagePdf(const PagePicture& page, const QString& path) {
    QPdfWriter pdf(path);
    pdf.setTitle(page.title);
    pdf.setCreator(QStringLiteral("Handlens"));
    pdf.setPageSize(QPageSize(page.size * kPointsPerPixel, QPageSize::Point));
    pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
    pdf.setResolution(kPixelsPerInch); // a unit is a pixel of the screen, and texts have the size that they have there
    QPainter painter;
    if (!painter.begin(&pdf))
        return false;
    painter.setRenderHint(QPainter::Antialiasing);
    paintParts(page, painter, kEmbeddedScale);
    return painter.end();
}

} // namespace widgets
