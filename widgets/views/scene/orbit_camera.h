// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QSize>

#include <Eigen/Core>

namespace widgets {

/// A viewpoint that circles around a point, with the horizon always level. World in mm.
struct OrbitCamera {
    Eigen::Vector3d focus = Eigen::Vector3d::Zero();
    Eigen::Vector3d up = -Eigen::Vector3d::UnitY();   ///< unit; the world's vertical
    Eigen::Vector3d away = -Eigen::Vector3d::UnitZ(); ///< unit; from the focus to the eye, never along `up`
    double distanceMm = 600;
    static constexpr double kViewAngleDeg = 30; ///< vertical

    Eigen::Vector3d eye() const { return focus + distanceMm * away; }
    Eigen::Vector3d right() const { return up.cross(away).normalized(); }
    /// Millimetres at the focus that one pixel of a window of this height covers.
    double mmPerPixel(int windowHeight) const;

    /// Turns by a drag of the pointer (px, y down): a window's height is half a turn. Stops short of looking along
    /// `up`.
    void orbit(QPointF drag, int windowHeight);
    /// Moves so that the focus follows the drag.
    void pan(QPointF drag, int windowHeight);
    /// Magnifies by `factor`; what lies in the focus plane under the pointer (px from the window's middle) stays under
    /// it.
    void zoom(double factor, QPointF fromMiddle, int windowHeight);
    /// Moves back until a ball around `centre` fills the window.
    void frame(const Eigen::Vector3d& centre, double radiusMm, QSize window);
    /// Puts the eye at a place and looks from there towards the focus.
    void standAt(const Eigen::Vector3d& eyeInWorld);
};

} // namespace widgets
