// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include "core/geometry/camera.h"
#include "widgets/views/scene/orbit_camera.h"

namespace widgets {

/// Depths (mm, along the view) between which things are drawn.
struct DepthRange {
    double nearMm = 1;
    double farMm = 1e4;
};

/// The matrix that takes VTK's view coordinates to clip coordinates exactly as `camera`'s intrinsics would draw an
/// image of camera.size; its lens is left out. VTK's pixels are half-open squares, so the centre of pixel (0, 0) lies
/// at (0.5, 0.5).
vtkSmartPointer<vtkMatrix4x4> projectionMatrix(const core::Camera& camera, const DepthRange& depths);

/// Makes VTK's camera a calibrated one, for a window of camera.size.
void setCalibrated(vtkCamera& vtk, const core::Camera& camera, const DepthRange& depths);

/// The camera whose whole image fits into the middle of a window.
core::Camera fittedToWindow(const core::Camera& camera, QSize window);

/// Makes VTK's camera the orbiting one.
void setOrbiting(vtkCamera& vtk, const OrbitCamera& orbit);

} // namespace widgets
