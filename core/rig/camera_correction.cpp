// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/rig/rig_refinement.h"

namespace core {

namespace {

/// Derivative of the distorted normalised point by k1 and k2.
Eigen::Matrix2d distortedByCoefficients(const Camera& camera, const Eigen::Vector2d& n) {
    const double r2 = n.squaredNorm();
    Eigen::Matrix2d result;
    if (camera.fisheye) {
        const double r = std::sqrt(r2), theta = std::atan(r), t3 = theta * theta * theta;
        const double scale = r < 1e-12 ? 0 : t3 / r;
        result << scale * n, scale * theta * theta * n;
        return result;
    }
    double bottom = 1;
    for (std::size_t i = 5, power = 1; i < std::min<std::size_t>(8, camera.distortion.size()); ++i, ++power)
        bottom += camera.distortion[i] * std::pow(r2, static_cast<double>(power));
    result << r2 / bottom * n, r2 * r2 / bottom * n;
    return result;
}

/// The right Jacobian of SO(3) for small angles: exp(w + d) = exp(w) exp(J d); its error is below |w|^3 / 24.
Eigen::Matrix3d rightJacobian(const Eigen::Vector3d& w) {
    const Eigen::Matrix3d cross = crossMatrix(w);
    return Eigen::Matrix3d::Identity() - cross / 2 + cross * cross / 6;
}

} // namespace

Camera corrected(const Camera& camera, const CameraCorrection& correction) {
    Camera result = camera;
    const Eigen::Vector3d centre = camera.centreInWorld() + correction.segment<3>(3);
    result.cameraFromWorld.rotation = rotationExp(correction.head<3>()) * camera.cameraFromWorld.rotation;
    result.cameraFromWorld.translation = -(result.cameraFromWorld.rotation * centre);
    result.intrinsics.topLeftCorner<2, 2>() *= std::exp(correction[6]);
    if (correction[7] != 0 || correction[8] != 0) {
        if (result.distortion.size() < 4)
            result.distortion.resize(4, 0.0);
        result.distortion[0] += correction[7];
        result.distortion[1] += correction[8];
    }
    return result;
}

std::optional<Eigen::Matrix<double, 2, 9>> pxByCorrection(const Camera& camera, const CameraCorrection& correction,
                                                          const Eigen::Vector3d& pointInWorld) {
    const Camera now = corrected(camera, correction);
    const auto projection = projectWithJacobian(now, pointInWorld);
    if (!projection)
        return std::nullopt;
    const RigidMotion& motion = now.cameraFromWorld;
    const Matrix23d pxByPointInCamera = projection->pxByPointInWorld * motion.rotation.transpose();
    const Eigen::Vector3d fromCentre = pointInWorld - now.centreInWorld();
    const Eigen::Vector3d unturned = camera.cameraFromWorld.rotation * fromCentre;
    Eigen::Matrix<double, 2, 9> jacobian;
    jacobian.leftCols<3>() = -pxByPointInCamera * rotationExp(correction.head<3>()) * crossMatrix(unturned) *
                             rightJacobian(correction.head<3>());
    jacobian.middleCols<3>(3) = -projection->pxByPointInWorld;
    jacobian.col(6) = projection->px - now.intrinsics.topRightCorner<2, 1>();
    const Eigen::Vector3d inCamera = motion * pointInWorld;
    const Eigen::Vector2d normalised = inCamera.head<2>() / inCamera.z();
    jacobian.rightCols<2>() = now.intrinsics.topLeftCorner<2, 2>() * distortedByCoefficients(now, normalised);
    return jacobian;
}

} // namespace core
