// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QWidget>

#include "core/geometry/camera.h"

namespace widgets {

/// Cameras in space as frusta with their names, about the point where they look. A drag turns them, the wheel brings
/// them nearer. Drawn without OpenGL, so that any number of windows may show one.
class RigDrawing : public QWidget {
    Q_OBJECT

public:
    explicit RigDrawing(QWidget* parent = nullptr);

    /// `odd`: indices of cameras that stand out in the colour of errors.
    void setCameras(const std::vector<core::Camera>& cameras, const std::set<int>& odd = {});
    /// Where a point of the world is drawn. No value if it lies behind the onlooker.
    std::optional<QPointF> place(const Eigen::Vector3d& pointInWorld) const;
    QSize sizeHint() const override { return {360, 260}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void drawCamera(QPainter& painter, std::size_t index) const;
    void line(QPainter& painter, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

    std::vector<core::Camera> m_cameras;
    std::set<int> m_odd;
    Eigen::Vector3d m_target = Eigen::Vector3d::Zero(), m_up = -Eigen::Vector3d::UnitY();
    double m_radius = 1; ///< of the rig, mm
    double m_turnRad = 0.6, m_tiltRad = 0.5, m_zoom = 1;
    QPoint m_pressed;
};

} // namespace widgets
