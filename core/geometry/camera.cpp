// SPDX-License-Identifier: MIT
#include "core/geometry/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

#include "core/geometry/lens_fold.h"

namespace core {

namespace {

LensCoefficients coefficients(const Camera& camera) {
    LensCoefficients k{};
    std::copy_n(camera.distortion.begin(), std::min<std::size_t>(8, camera.distortion.size()), k.begin());
    return k;
}

/// OpenCV's rational model: k1 k2 p1 p2 k3 k4 k5 k6.
Eigen::Vector2d distortRational(const Camera& camera, const Eigen::Vector2d& n, Eigen::Matrix2d* jacobian) {
    const auto [k1, k2, p1, p2, k3, k4, k5, k6] = coefficients(camera);
    const double x = n.x(), y = n.y(), r2 = x * x + y * y;
    const double top = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double bottom = 1 + r2 * (k4 + r2 * (k5 + r2 * k6));
    const double radial = top / bottom;
    if (jacobian) {
        const double topByR2 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
        const double bottomByR2 = k4 + r2 * (2 * k5 + r2 * 3 * k6);
        const double radialByR2 = (topByR2 - radial * bottomByR2) / bottom;
        const double mixed = 2 * x * y * radialByR2;
        *jacobian << radial + 2 * x * x * radialByR2 + 2 * p1 * y + 6 * p2 * x, mixed + 2 * p1 * x + 2 * p2 * y,
            mixed + 2 * p1 * x + 2 * p2 * y, radial + 2 * y * y * radialByR2 + 6 * p1 * y + 2 * p2 * x;
    }
    return {x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x), y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
}

/// OpenCV's fisheye model: theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8).
Eigen::Vector2d distortFisheye(const Camera& camera, const Eigen::Vector2d& n, Eigen::Matrix2d* jacobian) {
    const auto k = coefficients(camera);
    const double r = n.norm();
    if (r < 1e-12) {
        if (jacobian)
            jacobian->setIdentity();
        return n;
    }
    const double theta = std::atan(r), t2 = theta * theta;
    const double thetaD = theta * (1 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
    const double scale = thetaD / r;
    if (jacobian) {
        const double thetaDByTheta = 1 + t2 * (3 * k[0] + t2 * (5 * k[1] + t2 * (7 * k[2] + t2 * 9 * k[3])));
        const double scaleByR = (thetaDByTheta / (1 + r * r) - scale) / r;
        *jacobian = scale * Eigen::Matrix2d::Identity() + (scaleByR / r) * n * n.transpose();
    }
    return scale * n;
}

/// A value that is negative or small where the lens may fold back before the normalised point: with u = r^2, the slope
/// of the radial map, 1 + 3 k1 u + 5 k2 u^2 + 7 k3 u^3, is at least 1 plus its negative terms, on the whole way to the
/// point, and tangential terms change the Jacobian by at most 8 (|p1| + |p2|) r <= 4 (|p1| + |p2|) (1 + u).
double foldMargin(const LensCoefficients& k, double u) {
    const auto loss = [](double term) { return std::min(term, 0.0); };
    return 1 + loss(3 * k[0] * u) + loss(5 * k[1] * u * u) + loss(7 * k[4] * u * u * u) -
           4 * (std::abs(k[2]) + std::abs(k[3])) * (1 + u);
}

} // namespace

bool Camera::hasLens() const {
    return fisheye || std::any_of(
                          distortion.begin(), distortion.end(), [](double k) { return k != 0; });
}

Eigen::Vector2d distort(const Camera& camera, const Eigen::Vector2d& normalised, Eigen::Matrix2d* jacobian) {
    return camera.fisheye ? distortFisheye(camera, normalised, jacobian)
                          : distortRational(camera, normalised, jacobian);
}

bool lensHolds(const Camera& camera, const Eigen::Vector2d& n) {
    const LensCoefficients k = coefficients(camera);
    const bool isPolynomial = !camera.fisheye && k[5] == 0 && k[6] == 0 && k[7] == 0;
    if (isPolynomial && foldMargin(k, n.squaredNorm()) > 0.01)
        return true; // every ordinary lens
    if (!isBeforeFold(k, camera.fisheye, n.squaredNorm()))
        return false;
    Eigen::Matrix2d jacobian;
    distort(camera, n, &jacobian);
    return jacobian.determinant() > 0;
}

std::optional<Eigen::Vector2d> project(const Camera& camera, const Eigen::Vector3d& pointInWorld) {
    const Eigen::Vector3d p = camera.cameraFromWorld * pointInWorld;
    if (!(p.z() > 1e-9))
        return std::nullopt;
    Eigen::Vector2d n = p.head<2>() / p.z();
    if (camera.hasLens()) {
        if (!lensHolds(camera, n))
            return std::nullopt;
        n = distort(camera, n);
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
    constexpr int kMaxIterations = 30;
    for (int i = 0; i < kMaxIterations; ++i) {
        Eigen::Matrix2d jacobian;
        const Eigen::Vector2d error = distort(camera, n, &jacobian) - target;
        if (error.cwiseAbs().maxCoeff() < 1e-13)
            return lensHolds(camera, n) ? std::optional(n) : std::nullopt;
        if (!(jacobian.determinant() > 1e-6))
            return std::nullopt; // the lens model folds over here
        n -= jacobian.inverse() * error;
    }
    const double left = (distort(camera, n) - target).norm();
    return left < 1e-10 && lensHolds(camera, n) ? std::optional(n) : std::nullopt;
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
