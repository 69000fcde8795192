// SPDX-License-Identifier: MIT
#include "core/geometry/camera_faults.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/LU>

#include "core/geometry/camera_target.h"
#include "core/geometry/lens_coverage.h"

namespace core {

namespace {

constexpr double kRotationTolerance = 1e-3;
constexpr double kSamePlaceMm = 0.1;
constexpr double kSameShape = 0.01; ///< of the ratio of width and height
constexpr double kNearMm = 20;      ///< nearer than any rig around a hand
constexpr double kFarMm = 200e3;    ///< farther than any room is wide
constexpr double kCentimetresBelowMm = 100;
constexpr double kSideBySideMm = 5; ///< no two cameras with parallel axes stand closer

std::optional<CameraFault> rotationFault(const Camera& camera) {
    const Eigen::Matrix3d& r = camera.cameraFromWorld.rotation;
    const double off = (r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(off < kRotationTolerance))
        return CameraFault{CameraFaultKind::NotARotation, -1, off};
    if (r.determinant() < 0)
        return CameraFault{CameraFaultKind::NotARotation, -1, -1};
    return std::nullopt;
}

std::optional<CameraFault> lensFault(const Camera& camera) {
    const Eigen::Matrix3d& k = camera.intrinsics;
    if (!(k(0, 0) > 0) || !(k(1, 1) > 0))
        return CameraFault{CameraFaultKind::NoFocalLength, -1, std::min(k(0, 0), k(1, 1))};
    if (!(k(0, 2) > 0 && k(0, 2) < camera.size.width && k(1, 2) > 0 && k(1, 2) < camera.size.height))
        return CameraFault{CameraFaultKind::CentreOutside};
    const double holds = lensCoverage(camera);
    return holds < 1 ? std::optional(CameraFault{CameraFaultKind::LensFolds, -1, holds}) : std::nullopt;
}

std::optional<CameraFault> sizeFault(const Camera& camera, const std::optional<ImageSize>& pictures) {
    if (!pictures || *pictures == camera.size || *pictures == ImageSize{camera.size.height, camera.size.width} ||
        camera.size.width <= 0 || camera.size.height <= 0 || pictures->height <= 0)
        return std::nullopt;
    const double shape = double(camera.size.width) / camera.size.height;
    const double recorded = double(pictures->width) / pictures->height;
    for (const bool isTurned : {false, true}) {
        const double wanted = isTurned ? 1 / shape : shape;
        if (std::abs(recorded / wanted - 1) < kSameShape)
            return CameraFault{CameraFaultKind::OtherScale, -1,
                               double(pictures->width) / (isTurned ? camera.size.height : camera.size.width), -1,
                               *pictures};
    }
    return CameraFault{CameraFaultKind::OtherSize, -1, 0, -1, *pictures};
}

std::optional<CameraFault> placeFault(const std::vector<Camera>& cameras, std::size_t i,
                                      const std::optional<Eigen::Vector3d>& target) {
    for (std::size_t other = 0; other < i; ++other)
        if ((cameras[i].centreInWorld() - cameras[other].centreInWorld()).norm() < kSamePlaceMm)
            return CameraFault{CameraFaultKind::SamePlace, -1, 0, static_cast<int>(other)};
    if (!target)
        return std::nullopt;
    if ((cameras[i].cameraFromWorld.rotation * *target + cameras[i].cameraFromWorld.translation).z() <= 0)
        return CameraFault{CameraFaultKind::LooksAway};
    const std::optional<Eigen::Vector2d> px = project(cameras[i], *target);
    return px && isInside(cameras[i].size, *px) ? std::nullopt
                                                : std::optional(CameraFault{CameraFaultKind::TargetUnseen});
}

} // namespace

RigScale rigScale(const std::vector<Camera>& cameras) {
    RigScale scale;
    const std::optional<Eigen::Vector3d> target = commonTarget(cameras);
    scale.hasTarget = target.has_value();
    std::vector<double> distances;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const Eigen::Vector3d other = target ? *target : cameras[i == 0 ? cameras.size() - 1 : i - 1].centreInWorld();
        distances.push_back((cameras[i].centreInWorld() - other).norm());
    }
    std::sort(distances.begin(), distances.end());
    if (cameras.size() < 2)
        return scale;
    scale.distanceMm = distances[distances.size() / 2];
    if (scale.distanceMm == 0)
        return scale;
    if (scale.distanceMm < (scale.hasTarget ? kNearMm : kSideBySideMm))
        scale.likelyFactor = 1000;
    else if (scale.hasTarget && scale.distanceMm < kCentimetresBelowMm)
        scale.likelyFactor = 10;
    else if (scale.distanceMm > kFarMm)
        scale.likelyFactor = 0.001;
    return scale;
}

std::vector<CameraFault> findCameraFaults(const std::vector<Camera>& cameras,
                                          const std::vector<std::optional<ImageSize>>& pictureSizes) {
    std::vector<CameraFault> faults;
    std::vector<Camera> sound; // one without a rotation says nothing of where the others look
    std::copy_if(cameras.begin(), cameras.end(), std::back_inserter(sound),
                 [](const Camera& camera) { return !rotationFault(camera); });
    const std::optional<Eigen::Vector3d> target = commonTarget(sound);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const std::optional<ImageSize> pictures = i < pictureSizes.size() ? pictureSizes[i] : std::nullopt;
        const std::optional<CameraFault> rotation = rotationFault(cameras[i]);
        for (const auto& fault : {rotation, lensFault(cameras[i]), sizeFault(cameras[i], pictures),
                                  rotation ? std::nullopt : placeFault(cameras, i, target)}) {
            if (!fault)
                continue;
            faults.push_back(*fault);
            faults.back().camera = static_cast<int>(i);
        }
    }
    if (const RigScale scale = rigScale(sound); scale.likelyFactor != 1)
        faults.push_back({CameraFaultKind::OddUnit, -1, scale.distanceMm});
    return faults;
}

} // namespace core
