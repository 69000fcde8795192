// SPDX-License-Identifier: MIT
#include "core/geometry/camera_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/error.h"

namespace core {

namespace {

Camera lookingAt(const Eigen::Vector3d& target, double azimuthRad, double elevationRad, double distanceMm,
                 const CameraRingOptions& options) {
    Camera camera;
    camera.size = options.size;
    camera.intrinsics << options.focalPx, 0, 0.5 * (options.size.width - 1), 0, options.focalPx,
        0.5 * (options.size.height - 1), 0, 0, 1;
    // y points down, so a raised camera has a smaller y than its target.
    const Eigen::Vector3d outward(std::cos(elevationRad) * std::sin(azimuthRad), -std::sin(elevationRad),
                                  -std::cos(elevationRad) * std::cos(azimuthRad));
    const Eigen::Vector3d forward = -outward;
    const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(forward).normalized();
    camera.cameraFromWorld.rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
    camera.cameraFromWorld.translation = -(camera.cameraFromWorld.rotation * (target + distanceMm * outward));
    return camera;
}

bool seesAll(const Camera& camera, const std::vector<Eigen::Vector3d>& points, double marginPx) {
    const Eigen::Vector2d least = Eigen::Vector2d::Constant(marginPx);
    const Eigen::Vector2d most = Eigen::Vector2d(camera.size.width - 1, camera.size.height - 1) - least;
    return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& point) {
        const std::optional<Eigen::Vector2d> px = project(camera, point);
        return px && (*px - least).minCoeff() >= 0 && (most - *px).minCoeff() >= 0;
    });
}

} // namespace

std::vector<Camera> cameraRing(const std::vector<Eigen::Vector3d>& pointsInWorld, const CameraRingOptions& options) {
    if (pointsInWorld.empty() || options.count < 1)
        throw Error(ErrorCode::BadInput, "", "cameras", "a ring needs at least one camera and one point to look at");
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : pointsInWorld)
        box.extend(point);
    const auto ringAt = [&](double distanceMm) {
        std::vector<Camera> cameras;
        for (int i = 0; i < options.count; ++i) {
            const double azimuth = 2 * std::numbers::pi * i / options.count;
            cameras.push_back(lookingAt(box.center(), azimuth, i % 2 == 0 ? options.raisedRad : options.loweredRad,
                                        distanceMm, options));
            cameras.back().name = "cam" + std::to_string(i);
        }
        return cameras;
    };
    const auto isFarEnough = [&](double distanceMm) {
        const std::vector<Camera> cameras = ringAt(distanceMm);
        return std::all_of(cameras.begin(), cameras.end(),
                           [&](const Camera& camera) { return seesAll(camera, pointsInWorld, options.marginPx); });
    };
    double far = std::max(1.0, box.diagonal().norm());
    while (!isFarEnough(far) && far < 1e7)
        far *= 2;
    double near = 0;
    while (far - near > 1) { // to a millimetre
        const double middle = 0.5 * (near + far);
        (isFarEnough(middle) ? far : near) = middle;
    }
    return ringAt(std::ceil(far));
}

} // namespace core
