// SPDX-License-Identifier: MIT
#include "widgets/views/scene/scene_camera.h"

#include <algorithm>

namespace widgets {

vtkSmartPointer<vtkMatrix4x4> projectionMatrix(const core::Camera& camera, const DepthRange& depths) {
    const Eigen::Matrix3d& k = camera.intrinsics;
    const double width = camera.size.width, height = camera.size.height;
    const double n = depths.nearMm, f = depths.farMm;
    // View coordinates: x right, y up, z towards the viewer, that is (x, -y, -z) of the calibrated camera.
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    matrix->Zero();
    matrix->SetElement(0, 0, 2 * k(0, 0) / width);
    matrix->SetElement(0, 1, -2 * k(0, 1) / width);
    matrix->SetElement(0, 2, 1 - 2 * (k(0, 2) + 0.5) / width);
    matrix->SetElement(1, 1, 2 * k(1, 1) / height);
    matrix->SetElement(1, 2, 2 * (k(1, 2) + 0.5) / height - 1);
    matrix->SetElement(2, 2, -(f + n) / (f - n));
    matrix->SetElement(2, 3, -2 * f * n / (f - n));
    matrix->SetElement(3, 2, -1);
    return matrix;
}

void setCalibrated(vtkCamera& vtk, const core::Camera& camera, const DepthRange& depths) {
    const Eigen::Vector3d eye = camera.centreInWorld();
    const Eigen::Vector3d forward = camera.cameraFromWorld.rotation.row(2);
    const Eigen::Vector3d up = -camera.cameraFromWorld.rotation.row(1);
    const Eigen::Vector3d focus = eye + forward * std::max(1.0, (depths.nearMm + depths.farMm) / 2);
    vtk.SetPosition(eye.data());
    vtk.SetFocalPoint(focus.data());
    vtk.SetViewUp(up.data());
    vtk.SetClippingRange(depths.nearMm, depths.farMm);
    vtk.SetExplicitProjectionTransformMatrix(projectionMatrix(camera, depths));
    vtk.SetUseExplicitProjectionTransformMatrix(true);
}

core::Camera fittedToWindow(const core::Camera& camera, QSize window) {
    const double scale = std::min(static_cast<double>(window.width()) / camera.size.width,
                                  static_cast<double>(window.height()) / camera.size.height);
    const Eigen::Vector2d margin(window.width() - camera.size.width * scale,
                                 window.height() - camera.size.height * scale);
    return core::cropped(camera, -margin / (2 * scale), {window.width(), window.height()}, scale);
}

void setOrbiting(vtkCamera& vtk, const OrbitCamera& orbit) {
    const Eigen::Vector3d eye = orbit.eye();
    vtk.SetUseExplicitProjectionTransformMatrix(false);
    vtk.SetPosition(eye.data());
    vtk.SetFocalPoint(orbit.focus.data());
    vtk.SetViewUp(orbit.up.data());
    vtk.SetViewAngle(OrbitCamera::kViewAngleDeg);
}

} // namespace widgets
