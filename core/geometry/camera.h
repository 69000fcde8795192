// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pluecker_line.h"
#include "core/geometry/rigid_motion.h"

namespace core {

/// Width and height in pixels.
struct ImageSize {
    int width = 0;
    int height = 0;
    bool operator==(const ImageSize&) const = default;
};

/// A calibrated camera with OpenCV's conventions: x_cam = R x_world + t (mm), x right, y down, z forward;
/// pixel centres at integers. `distortion` holds none, 4, 5, or 8 coefficients k1 k2 p1 p2 [k3 [k4 k5 k6]],
/// or, with `fisheye`, the four of OpenCV's fisheye model.
struct Camera {
    std::string name;
    ImageSize size;
    Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();
    std::vector<double> distortion;
    bool fisheye = false;
    RigidMotion cameraFromWorld;

    bool hasLens() const;
    Eigen::Vector3d centreInWorld() const {
        return -(cameraFromWorld.rotation.transpose() * cameraFromWorld.translation);
    }
};

using Matrix23d = Eigen::Matrix<double, 2, 3>;

/// A projected point with the derivative of its pixel by the world point (px/mm).
struct Projection {
    Eigen::Vector2d px;
    Matrix23d pxByPointInWorld;
};

/// The recorded (distorted) pixel of a world point; empty if it lies on or behind the camera's plane,
/// or beyond the radius at which the lens model folds back (it would be shown mirrored).
std::optional<Eigen::Vector2d> project(const Camera& camera, const Eigen::Vector3d& pointInWorld);
std::optional<Projection> projectWithJacobian(const Camera& camera, const Eigen::Vector3d& pointInWorld);

/// Lens distortion of normalised coordinates (x/z, y/z), and its 2x2 Jacobian if asked for.
Eigen::Vector2d distort(const Camera& camera, const Eigen::Vector2d& normalised, Eigen::Matrix2d* jacobian = nullptr);

/// False for normalised coordinates beyond the radius at which the lens model folds back, or where its tangential terms
/// turn the image over: no pixel shows them.
bool lensHolds(const Camera& camera, const Eigen::Vector2d& normalised);

/// Normalised coordinates of a recorded pixel, by Newton iteration to 1e-12; empty where the lens model
/// cannot be inverted (far outside the image).
std::optional<Eigen::Vector2d> undistort(const Camera& camera, const Eigen::Vector2d& px);

/// The projection ray of a recorded pixel in the world, directed away from the camera.
std::optional<PlueckerLine> viewingRay(const Camera& camera, const Eigen::Vector2d& px);

/// True if the pixel lies within the image (centres at integers, so from -0.5 to size - 0.5).
bool isInside(const ImageSize& size, const Eigen::Vector2d& px);

/// The camera of the same lens that sees the window of the image whose top left pixel is `topLeftPx`, scaled by
/// `scale` (pixels of the new image per pixel of the old one). Centres stay at integers: 0.5 px is accounted for.
Camera cropped(const Camera& camera, const Eigen::Vector2d& topLeftPx, ImageSize size, double scale = 1.0);

} // namespace core
