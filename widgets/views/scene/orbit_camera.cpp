// SPDX-License-Identifier: MIT
#include "widgets/views/scene/orbit_camera.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace widgets {

namespace {

constexpr double kNearestMm = 5;
constexpr double kFarthestMm = 1e5;
constexpr double kSteepestRad = 1.54; // elevation, just short of straight up or down

} // namespace

double OrbitCamera::mmPerPixel(int windowHeight) const {
    const double halfAngle = kViewAngleDeg * M_PI / 360;
    return 2 * distanceMm * std::tan(halfAngle) / std::max(1, windowHeight);
}

void OrbitCamera::orbit(QPointF drag, int windowHeight) {
    const double radPerPixel = M_PI / std::max(1, windowHeight);
    const double elevation = std::asin(std::clamp(away.dot(up), -1.0, 1.0));
    const double wanted = std::clamp(elevation + drag.y() * radPerPixel, -kSteepestRad, kSteepestRad);
    away = Eigen::AngleAxisd(elevation - wanted, right()) * away;
    away = (Eigen::AngleAxisd(-drag.x() * radPerPixel, up) * away).normalized();
}

void OrbitCamera::pan(QPointF drag, int windowHeight) {
    const Eigen::Vector3d upInView = away.cross(right());
    focus += mmPerPixel(windowHeight) * (drag.y() * upInView - drag.x() * right());
}

void OrbitCamera::zoom(double factor, QPointF fromMiddle, int windowHeight) {
    const double before = distanceMm;
    distanceMm = std::clamp(distanceMm / factor, kNearestMm, kFarthestMm);
    // The point under the pointer keeps its offset in px, which now covers fewer millimetres.
    const double moved = (before / distanceMm - 1) * mmPerPixel(windowHeight);
    const Eigen::Vector3d upInView = away.cross(right());
    focus += moved * (fromMiddle.x() * right() - fromMiddle.y() * upInView);
}

void OrbitCamera::frame(const Eigen::Vector3d& centre, double radiusMm, QSize window) {
    const double aspect = std::min(1.0, static_cast<double>(window.width()) / std::max(1, window.height()));
    const double halfAngle = std::atan(std::tan(kViewAngleDeg * M_PI / 360) * std::max(0.1, aspect));
    focus = centre;
    distanceMm = std::clamp(radiusMm / std::sin(halfAngle), kNearestMm, kFarthestMm);
}

void OrbitCamera::standAt(const Eigen::Vector3d& eyeInWorld) {
    const Eigen::Vector3d offset = eyeInWorld - focus;
    if (offset.norm() < kNearestMm || offset.cross(up).norm() < 0.03 * offset.norm())
        return;
    distanceMm = offset.norm();
    away = offset.normalized();
}

} // namespace widgets
