// SPDX-License-Identifier: MIT
#include "widgets/views/rig_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "core/geometry/camera_target.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

const QColor kOddColour(0xE5, 0x5B, 0x5B);
constexpr double kDistance = 3.2; ///< of the onlooker, in radii of the rig
constexpr double kFrustum = 0.22; ///< length, in radii

} // namespace

RigDrawing::RigDrawing(QWidget* parent)
    : QWidget(parent) {
    setMinimumSize(180, 140);
    setCursor(Qt::OpenHandCursor);
    setToolTip(tr("The cameras of the calibration, and where they look. Drag to turn, wheel to zoom."));
}

void RigDrawing::setCameras(const std::vector<core::Camera>& cameras, const std::set<int>& odd) {
    m_cameras = cameras;
    m_odd = odd;
    if (cameras.empty()) {
        update();
        return;
    }
    m_target = core::commonTargetNearOrigin(cameras);
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
    std::vector<double> distances;
    for (const core::Camera& camera : cameras) {
        up -= camera.cameraFromWorld.rotation.row(1).transpose(); // y of the image points down
        distances.push_back((camera.centreInWorld() - m_target).norm());
    }
    m_up = up.allFinite() && up.norm() > 1e-6 ? Eigen::Vector3d(up.normalized()) : Eigen::Vector3d(0, -1, 0);
    std::sort(distances.begin(), distances.end());
    const double middle = distances[distances.size() / 2];
    m_radius = std::isfinite(middle) && middle > 0 ? middle : 1;
    update();
}

std::optional<QPointF> RigDrawing::place(const Eigen::Vector3d& pointInWorld) const {
    Eigen::Vector3d side = m_up.cross(Eigen::Vector3d::UnitX());
    if (side.norm() < 0.1)
        side = m_up.cross(Eigen::Vector3d::UnitZ());
    side.normalize();
    const Eigen::Vector3d ahead = side.cross(m_up);
    const Eigen::Vector3d level = std::cos(m_turnRad) * ahead + std::sin(m_turnRad) * side;
    const Eigen::Vector3d out = std::cos(m_tiltRad) * level + std::sin(m_tiltRad) * m_up; // towards the onlooker
    const Eigen::Vector3d right = m_up.cross(out).normalized(), above = out.cross(right);
    const Eigen::Vector3d p = (pointInWorld - m_target) / m_radius;
    const double depth = kDistance - p.dot(out);
    if (!(depth > 0.1))
        return std::nullopt;
    const double scale = m_zoom * 0.42 * kDistance * std::min(width(), height()) / depth;
    return QPointF(width() / 2.0 + scale * p.dot(right), height() / 2.0 - scale * p.dot(above));
}

void RigDrawing::line(QPainter& painter, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    const auto from = place(a), to = place(b);
    if (from && to)
        painter.drawLine(*from, *to);
}

void RigDrawing::drawCamera(QPainter& painter, std::size_t index) const {
    const core::Camera& camera = m_cameras[index];
    const Eigen::Vector3d centre = camera.centreInWorld();
    if (!centre.allFinite() || !(camera.intrinsics(0, 0) > 0) || !(camera.intrinsics(1, 1) > 0))
        return;
    const double length = kFrustum * m_radius;
    const Eigen::Matrix3d worldFromCamera = camera.cameraFromWorld.rotation.transpose();
    std::array<Eigen::Vector3d, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = (i == 1 || i == 2 ? camera.size.width : 0) - camera.intrinsics(0, 2);
        const double y = (i >= 2 ? camera.size.height : 0) - camera.intrinsics(1, 2);
        corners[i] = centre + length * (worldFromCamera *
                                        Eigen::Vector3d(x / camera.intrinsics(0, 0), y / camera.intrinsics(1, 1), 1));
    }
    const QColor colour = m_odd.count(static_cast<int>(index)) > 0 ? kOddColour : palette().color(QPalette::WindowText);
    QColor quiet = palette().color(QPalette::Highlight);
    quiet.setAlphaF(0.35);
    painter.setPen(QPen(quiet, 1));
    line(painter, centre, centre + worldFromCamera.col(2) * (m_target - centre).norm());
    painter.setPen(QPen(colour, 1.5));
    for (std::size_t i = 0; i < 4; ++i) {
        line(painter, centre, corners[i]);
        line(painter, corners[i], corners[(i + 1) % 4]);
    }
    if (const auto at = place(centre))
        painter.drawText(*at + QPointF(4, -4), toQString(camera.name));
}

void RigDrawing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_cameras.empty()) {
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The cameras appear here once the calibration is read."));
        return;
    }
    for (std::size_t i = 0; i < m_cameras.size(); ++i)
        drawCamera(painter, i);
    if (const auto at = place(m_target)) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawLine(*at - QPointF(5, 0), *at + QPointF(5, 0));
        painter.drawLine(*at - QPointF(0, 5), *at + QPointF(0, 5));
    }
}

void RigDrawing::mousePressEvent(QMouseEvent* event) {
    m_pressed = event->pos();
}

void RigDrawing::mouseMoveEvent(QMouseEvent* event) {
    constexpr double kRadPerPixel = 0.01, kMostTiltRad = 1.5;
    const QPoint moved = event->pos() - m_pressed;
    m_pressed = event->pos();
    m_turnRad -= kRadPerPixel * moved.x();
    m_tiltRad = std::clamp(m_tiltRad + kRadPerPixel * moved.y(), -kMostTiltRad, kMostTiltRad);
    update();
}

void RigDrawing::wheelEvent(QWheelEvent* event) {
    m_zoom = std::clamp(m_zoom * std::pow(1.2, event->angleDelta().y() / 120.0), 0.2, 10.0);
    update();
    event->accept();
}

} // namespace widgets
