// SPDX-License-Identifier: MIT
#include "core/geometry/camera.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/geometry/lens_model.h"

namespace core {

bool Camera::hasLens() const {
    return fisheye || std::any_of(
                          distortion.begin(), distortion.end(), [](double k) { return k != 0; });
}

Eigen::Vector2d distort(const Camera& camera, const Eigen::Vector2d& normalised, Eigen::Matrix2d* jacobian) {
    return LensModel(camera.distortion, camera.fisheye).distort(normalised, jacobian);
}

bool lensHolds(const Camera& camera, const Eigen::Vector2d& normalised) {
    return LensModel(camera.distortion, camera.fisheye).holds(normalised);
}

std::optional<Eigen::Vector2d> project(const Camera& camera, const Eigen::Vector3d& pointInWorld) {
    const Eigen::Vector3d p = camera.cameraFromWorld * pointInWorld;
    if (!(p.z() > 1e-9))
        return std::nullopt;
    Eigen::Vector2d n = p.head<2>() / p.z();
    if (camera.hasLens()) {
        const LensModel lens(camera.distortion, camera.fisheye);
        if (!lens.holds(n))
            return std::nullopt;
        n = lens.distort(n);
    }
    return camera.intrinsics.topLeftCorner<2, 2>() * n + camera.intrinsics.topRightCorner<2, 1>();
}

std::optional<Projection> projectWithJacobian(const Camera& camera, const Eigen::Vector3d& pointInWorld) {
    const Eigen::Vector3d p = camera.cameraFromWorld * pointInWorld;
    if (!(p.z() > 1e-9))
        return std::nullopt;
    const Eigen::Vector2d n = p.head<2>() / p.z();
    if (camera.hasLens() && !lensHolds(camera, n))
        return std::nullopt;
    Matrix23d normalisedByPoint;
    normalisedByPoint << 1 / p.z(), 0, -n.x() / p.z(), 0, 1 / p.z(), -n.y() / p.z();
    Eigen::Matrix2d lens;
    const Eigen::Vector2d d = distort(camera, n, &lens);
    const Eigen::Matrix2d k = camera.intrinsics.topLeftCorner<2, 2>();
    return Projection{k * d + camera.intrinsics.topRightCorner<2, 1>(),
                      k * lens * normalisedByPoint * camera.cameraFromWorld.rotation};
}

std::optional<Eigen::Vector2d> undistort(const Camera& camera, const Eigen::Vector2d& px) {
    const Eigen::Vector2d target =
        camera.intrinsics.topLeftCorner<2, 2>().inverse() * (px - camera.intrinsics.topRightCorner<2, 1>());
    if (!camera.hasLens())
        return target;
    Eigen::Vector2d n = target;
    if (camera.fisheye) {
        // Start from the inverse of the undistorted fisheye: r = tan(theta).
        const double theta = std::min(target.norm(), 1.5);
        n = theta > 1e-12 ? Eigen::Vector2d(target * (std::tan(theta) / target.norm())) : target;
    }
    const LensModel lens(camera.distortion, camera.fisheye);
    constexpr int kMaxIterations = 30;
    for (int i = 0; i < kMaxIterations; ++i) {
        Eigen::Matrix2d jacobian;
        const Eigen::Vector2d error = lens.distort(n, &jacobian) - target;
        if (error.cwiseAbs().maxCoeff() < 1e-13)
            return lens.holds(n) ? std::optional(n) : std::nullopt;
        if (!(jacobian.determinant() > 1e-6))
            return std::nullopt; // the lens model folds over here
        n -= jacobian.inverse() * error;
    }
    const double left = (lens.distort(n) - target).norm();
    return left < 1e-10 && lens.holds(n) ? std::optional(n) : std::nullopt;
}

std::optional<PlueckerLine> viewingRay(const Camera& camera, const Eigen::Vector2d& px) {
    const auto n = undistort(camera, px);
    if (!n)
        return std::nullopt;
    const Eigen::Vector3d direction = camera.cameraFromWorld.rotation.transpose() * n->homogeneous();
    return PlueckerLine::through(camera.centreInWorld(), direction);
}

bool isInside(const ImageSize& size, const Eigen::Vector2d& px) {
    return px.x() >= -0.5 && px.y() >= -0.5 && px.x() < size.width - 0.5 && px.y() < size.height - 0.5;
}

Camera cropped(const Camera& camera, const Eigen::Vector2d& topLeftPx, ImageSize size, double scale) {
    Camera result = camera;
    result.size = size;
    result.intrinsics.topRows<2>() *= scale;
    // Pixel edges, not centres, are scaled: (x - left + 0.5) * scale - 0.5.
    const Eigen::Vector2d shift = ((Eigen::Vector2d(0.5, 0.5) - topLeftPx) * scale).array() - 0.5;
    result.intrinsics.topRightCorner<2, 1>() += shift;
    return result;
}

} // namespace core
