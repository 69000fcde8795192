// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"

namespace core {

/// A rig to look at something from all sides.
struct CameraRingOptions {
    int count = 8;
    ImageSize size{1080, 1920};
    double focalPx = 1800;
    double marginPx = 80;      ///< between every point and the image border
    double raisedRad = 0.42;   ///< elevation of cameras 0, 2, 4, ...: about 24 degrees above
    double loweredRad = -0.24; ///< elevation of cameras 1, 3, 5, ...: about 14 degrees below
};

/// Cameras cam0, cam1, ... without lens distortion on a ring about the vertical (y, down) through the middle of the
/// points, all at the one distance that just keeps every point (world, mm) inside every image by the margin. Throws
/// Error(BadInput) for no points or fewer than one camera.
std::vector<Camera> cameraRing(const std::vector<Eigen::Vector3d>& pointsInWorld,
                               const CameraRingOptions& options = {});

} // namespace core
