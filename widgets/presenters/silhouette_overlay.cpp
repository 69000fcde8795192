// SPDX-License-Identifier: MIT
#include "widgets/presenters/silhouette_overlay.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <opencv2/imgproc.hpp>

namespace widgets {

namespace {

const QColor kTint(0x4d, 0xa3, 0xff, 90), kOutline(0x4d, 0xa3, 0xff), kCut(0xff, 0x8a, 0x00);
constexpr double kLeastRadiusPx = 1, kMostRadiusPx = 200;
constexpr double kWheelFactor = 1.15;
constexpr int kOutlinePx = 3;
constexpr double kMostCursor = 120; ///< pixels of the screen, half

QCursor ringCursor(double radius) {
    const double half = std::clamp(radius, 2.0, kMostCursor);
    const int side = 2 * static_cast<int>(std::ceil(half)) + 5;
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF centre(side / 2.0, side / 2.0);
    painter.setPen(QPen(Qt::black, 3));
    painter.drawEllipse(centre, half, half);
    painter.setPen(QPen(Qt::white, 1));
    painter.drawEllipse(centre, half, half);
    return QCursor(pixmap);
}

} // namespace

QImage silhouettePicture(const core::Silhouette& silhouette) {
    const cv::Mat& mask = silhouette.mask;
    cv::Mat inside;
    cv::erode(mask, inside, cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * kOutlinePx + 1, 2 * kOutlinePx + 1}));
    const QRgb tint = qPremultiply(kTint.rgba()), outline = qPremultiply(kOutline.rgba());
    QImage picture(mask.cols, mask.rows, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < mask.rows; ++y) {
        const auto* lit = mask.ptr<uchar>(y);
        const auto* deep = inside.ptr<uchar>(y);
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < mask.cols; ++x)
            row[x] = lit[x] == 0 ? 0 : (deep[x] == 0 ? outline : tint);
    }
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(kCut, 2 * kOutlinePx, Qt::DashLine));
    for (const core::ForearmLine& cut : silhouette.cuts)
        painter.drawLine(QPointF(cut.from.x() + 0.5, cut.from.y() + 0.5), QPointF(cut.to.x() + 0.5, cut.to.y() + 0.5));
    return picture;
}

SilhouetteOverlay::SilhouetteOverlay(SilhouetteStudy& study, CameraGrid& grid, QObject* parent)
    : QObject(parent)
    , m_study(study)
    , m_grid(grid) {
    connect(&study, &SilhouetteStudy::changed, this, &SilhouetteOverlay::show);
    connect(&study, &SilhouetteStudy::cleared, this, &SilhouetteOverlay::clear);
    connect(&grid, &CameraGrid::viewAdded, this, &SilhouetteOverlay::watchViews);
    watchViews();
}

SilhouetteOverlay::~SilhouetteOverlay() = default;

void SilhouetteOverlay::watchViews() {
    for (CameraView* view : m_grid.views()) {
        view->viewport()->removeEventFilter(this);
        view->viewport()->installEventFilter(this);
    }
}

void SilhouetteOverlay::show(int camera) {
    if (camera >= m_grid.count())
        return;
    const auto shown = m_study.shown().find(camera);
    m_grid.view(camera)->setFieldImage(
        shown == m_study.shown().end() ? QImage() : silhouettePicture(shown->second.silhouette), 1, true);
}

void SilhouetteOverlay::clear() {
    m_camera = -1;
    for (CameraView* view : m_grid.views())
        view->setFieldImage({});
}

void SilhouetteOverlay::setBrushOn(bool on) {
    m_brushOn = on;
    m_camera = -1;
    refreshCursors();
    emit brushChanged();
}

void SilhouetteOverlay::setBrushRadius(double radiusPx) {
    m_radiusPx = std::clamp(radiusPx, kLeastRadiusPx, kMostRadiusPx);
    refreshCursors();
    emit brushChanged();
}

void SilhouetteOverlay::refreshCursors() {
    for (CameraView* view : m_grid.views())
        if (m_brushOn)
            view->viewport()->setCursor(ringCursor(m_radiusPx * view->scale()));
        else
            view->viewport()->unsetCursor();
}

int SilhouetteOverlay::viewOf(const QObject* viewport) const {
    for (int i = 0; i < m_grid.count(); ++i)
        if (m_grid.view(i)->viewport() == viewport)
            return i;
    return -1;
}

/// Middle drags and clicks where there is no silhouette are the view's own.
bool SilhouetteOverlay::press(int camera, const QMouseEvent& event) {
    const auto shown = m_study.shown().find(camera);
    const bool isOurs = event.button() == Qt::LeftButton || event.button() == Qt::RightButton;
    if (!isOurs || shown == m_study.shown().end())
        return false;
    m_camera = camera;
    m_isForeground = event.button() == Qt::LeftButton && !event.modifiers().testFlag(Qt::ShiftModifier);
    m_stroke = shown->second.silhouette.mask.clone();
    m_lastPx = m_grid.view(camera)->viewportToImage(event.localPos());
    paintTo(m_lastPx);
    return true;
}

void SilhouetteOverlay::paintTo(QPointF px) {
    constexpr int kShift = 4;
    const auto at = [](QPointF point) {
        return cv::Point(static_cast<int>(std::lround(point.x() * (1 << kShift))),
                         static_cast<int>(std::lround(point.y() * (1 << kShift))));
    };
    const int thickness = std::max(1, static_cast<int>(std::lround(2 * m_radiusPx)));
    cv::line(m_stroke, at(m_lastPx), at(px), cv::Scalar(m_isForeground ? 255 : 0), thickness, cv::LINE_8, kShift);
    m_lastPx = px;
    m_grid.view(m_camera)->setFieldImage(silhouettePicture({m_stroke, m_study.shown().at(m_camera).silhouette.cuts}), 1,
                                         true);
}

bool SilhouetteOverlay::eventFilter(QObject* watched, QEvent* event) {
    const int camera = m_brushOn ? viewOf(watched) : -1;
    if (camera < 0)
        return QObject::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return press(camera, *static_cast<QMouseEvent*>(event)) || QObject::eventFilter(watched, event);
    case QEvent::MouseMove:
        if (m_camera != camera)
            return QObject::eventFilter(watched, event);
        paintTo(m_grid.view(camera)->viewportToImage(static_cast<QMouseEvent*>(event)->localPos()));
        return true;
    case QEvent::MouseButtonRelease:
        if (m_camera != camera)
            return QObject::eventFilter(watched, event);
        m_camera = -1;
        m_study.touchUp(camera, m_stroke);
        return true;
    case QEvent::ContextMenu:
        return true;
    case QEvent::Wheel:
        if (const auto* wheel = static_cast<QWheelEvent*>(event); wheel->modifiers().testFlag(Qt::ControlModifier)) {
            setBrushRadius(m_radiusPx * std::pow(kWheelFactor, wheel->angleDelta().y() / 120.0));
            return true;
        }
        return QObject::eventFilter(watched, event);
    default:
        return QObject::eventFilter(watched, event);
    }
}

} // namespace widgets
