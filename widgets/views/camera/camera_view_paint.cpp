// SPDX-License-Identifier: MIT
#include "widgets/views/camera/camera_view.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMenu>
#include <QScrollBar>
#include <QSvgGenerator>

#include "widgets/views/camera/camera_view_items.h"
#include "widgets/views/camera/camera_view_mouse.h"
#include "widgets/views/camera/loupe.h"
#include "widgets/views/camera/view_cursor.h"
#include "widgets/views/message_bar.h"
#include "widgets/views/page_picture.h"
#include "widgets/views/picture_export.h"

namespace widgets {

namespace {

constexpr double kShowPixelsScale = 4; // from here on, single pixels are shown as squares
const QColor kBackdrop(0x17, 0x18, 0x1A);
const QColor kVeil(0x17, 0x18, 0x1A, 130);

} // namespace

MeshLayerPainter::Request CameraView::meshRequest(double pictureScale) const {
    const double perImagePixel = scale() * pictureScale;
    const QSize size(static_cast<int>(std::ceil(viewport()->width() * pictureScale)),
                     static_cast<int>(std::ceil(viewport()->height() * pictureScale)));
    return {m_camera, m_meshLayers, QPointF(-transform().dx(), -transform().dy()) / scale(), size, perImagePixel};
}

void CameraView::requestMeshPicture() {
    const bool wanted = !m_meshLayers.empty() || !m_meshPainter->picture().picture.isNull();
    if (isVisible() && wanted && m_camera.size.width > 0)
        m_meshPainter->request(meshRequest(devicePixelRatioF()));
}

void CameraView::finishDrawing() {
    m_meshPainter->finish();
}

const QImage& CameraView::level(int index) const {
    if (m_adjustment == ImageAdjustment{})
        return m_pyramid.level(index);
    m_adjustedLevels.resize(static_cast<std::size_t>(m_pyramid.levelCount()));
    QImage& level = m_adjustedLevels[static_cast<std::size_t>(index)];
    if (level.isNull())
        level = adjusted(m_pyramid.level(index), m_adjustment);
    return level;
}

void CameraView::paintImage(QPainter& painter, double pixelsPerImagePixel) const {
    const QRectF whole(QPointF(0, 0), imageSize());
    if (m_pyramid.isNull()) {
        painter.fillRect(whole, QColor(0x26, 0x28, 0x2B));
        return;
    }
    const int index = m_pyramid.levelFor(pixelsPerImagePixel);
    const QImage& image = level(index);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, pixelsPerImagePixel < kShowPixelsScale);
    // A level of an odd size reaches half a pixel of its own beyond the image.
    const double across = whole.width() / m_pyramid.size().width(), down = whole.height() / m_pyramid.size().height();
    const QRectF target(0, 0, image.width() * across * (1 << index), image.height() * down * (1 << index));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setClipRect(whole, Qt::IntersectClip);
    painter.drawImage(target, image);
    if (m_awaiting)
        painter.fillRect(whole, kVeil);
    painter.restore();
}

void CameraView::paintMeshes(QPainter& painter, const MeshPicture& meshes) const {
    if (meshes.picture.isNull())
        return;
    const QRectF place(meshes.topLeftPx, QSizeF(meshes.picture.size()) / meshes.scale);
    const QRectF onScreen = painter.worldTransform().mapRect(place);
    const QRectF snapped(onScreen.topLeft().toPoint(), onScreen.size().toSize());
    const double off =
        std::max((onScreen.topLeft() - snapped.topLeft()).manhattanLength(),
                 std::abs(onScreen.width() - snapped.width()) + std::abs(onScreen.height() - snapped.height()));
    painter.save();
    constexpr double kSame = 1e-6;
    if (off < kSame) { // drawn for this very crop: pixel for pixel
        painter.resetTransform();
        painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
        painter.drawImage(snapped, meshes.picture);
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(place, meshes.picture);
    }
    painter.restore();
}

void CameraView::paintField(QPainter& painter) const {
    if (m_field.isNull())
        return;
    painter.setOpacity(m_fieldOpacity);
    painter.drawImage(QRectF(QPointF(0, 0), imageSize()), m_field);
    painter.setOpacity(1);
}

void CameraView::drawBackground(QPainter* painter, const QRectF& rect) {
    painter->fillRect(rect, kBackdrop);
    if (imageSize().isEmpty())
        return;
    paintImage(*painter, scale() * devicePixelRatioF());
    if (m_overlaysHidden)
        return;
    if (!m_fieldOverMeshes)
        paintField(*painter);
    paintMeshes(*painter, m_meshPainter->picture());
    if (m_fieldOverMeshes)
        paintField(*painter);
}

/// Everything, on any paint device whose logical size is the viewport's.
void CameraView::paintAll(QPainter& painter, double pictureScale) const {
    const QRectF area(viewport()->rect());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(area);
    painter.fillRect(area, kBackdrop);
    painter.save();
    painter.setTransform(viewportTransform(), true);
    paintImage(painter, scale() * pictureScale);
    if (!m_overlaysHidden) {
        if (!m_fieldOverMeshes)
            paintField(painter);
        const MeshLayerPainter::Request r = meshRequest(pictureScale);
        paintMeshes(painter, drawMeshLayers(r.camera, r.layers, r.topLeftPx, r.size, r.scale));
        if (m_fieldOverMeshes)
            paintField(painter);
    }
    painter.restore();
    m_scene->render(&painter, area, viewportTransform().inverted().mapRect(area));
}

QImage CameraView::grabPicture(double pictureScale) const {
    QImage picture((QSizeF(viewport()->size()) * pictureScale).toSize(), QImage::Format_RGB32);
    picture.fill(kBackdrop); // the last row and column may be a part of a pixel more than the view
    picture.setDevicePixelRatio(pictureScale);
    QPainter painter(&picture);
    paintAll(painter, pictureScale);
    painter.end();
    picture.setDevicePixelRatio(1);
    return picture;
}

bool CameraView::saveSvg(const QString& path) const {
    QSvgGenerator svg;
    svg.setFileName(path);
    svg.setSize(viewport()->size());
    svg.setViewBox(viewport()->rect());
    svg.setTitle(m_titleBar->title().name);
    QPainter painter;
    if (!painter.begin(&svg))
        return false;
    constexpr double kEmbeddedScale = 2;
    paintAll(painter, kEmbeddedScale);
    return painter.end();
}

bool CameraView::savePdf(const QString& path) const {
    const QSizeF size(viewport()->size());
    return savePagePdf({m_titleBar->title().name,
                        size,
                        kBackdrop,
                        {{QRectF(QPointF(0, 0), size), [this](QPainter& p, double scale) { paintAll(p, scale); }}}},
                       path);
}

void CameraView::addPictureActions(QMenu& menu) {
    widgets::addPictureActions(menu, this,
                               {[this](double s) { return grabPicture(s); },
                                [this](const QString& p) { return saveSvg(p); }, m_titleBar->title().name,
                                [this](const QString& text) { setMessage(text); },
                                [this](const QString& p) { return savePdf(p); }});
}

void CameraView::setTitle(const ViewTitle& title) {
    m_titleBar->setTitle(title);
}

const ViewTitle& CameraView::title() const {
    return m_titleBar->title();
}

void CameraView::layOut() {
    const int titleHeight = m_titleBar->sizeHint().height();
    setViewportMargins(0, titleHeight, 0, 0);
    m_titleBar->setGeometry(0, 0, width(), titleHeight);
    const int messageHeight = std::max(m_messageBar->heightForWidth(width()), m_messageBar->sizeHint().height());
    m_messageBar->setGeometry(0, titleHeight, width(), std::min(messageHeight, height() / 2));
}

} // namespace widgets
