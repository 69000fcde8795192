// SPDX-License-Identifier: MIT
#include "core/geometry/rigid_motion.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace core {

RigidMotion operator*(const RigidMotion& cFromB, const RigidMotion& bFromA) {
    return {cFromB.rotation * bFromA.rotation, cFromB.rotation * bFromA.translation + cFromB.translation};
}

RigidMotion inverse(const RigidMotion& bFromA) {
    return {bFromA.rotation.transpose(), -(bFromA.rotation.transpose() * bFromA.translation)};
}

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

namespace {

/// sin(a)/a, (1-cos a)/a^2 and (a - sin a)/a^3, from their series where the quotients would cancel.
struct RotationCoefficients {
    double a, b, c;
};

RotationCoefficients rotationCoefficients(double angleSquared) {
    if (angleSquared < 1e-8)
        return {1.0 - angleSquared / 6.0, 0.5 - angleSquared / 24.0, 1.0 / 6.0 - angleSquared / 120.0};
    const double angle = std::sqrt(angleSquared);
    const double half = std::sin(0.5 * angle);
    return {std::sin(angle) / angle, 2.0 * half * half / angleSquared,
            (angle - std::sin(angle)) / (angleSquared * angle)};
}

} // namespace

Eigen::Matrix3d rotationExp(const Eigen::Vector3d& rotationVectorRad) {
    const auto [a, b, c] = rotationCoefficients(rotationVectorRad.squaredNorm());
    const Eigen::Matrix3d w = crossMatrix(rotationVectorRad);
    return Eigen::Matrix3d::Identity() + a * w + b * w * w;
}

Eigen::Vector3d rotationLog(const Eigen::Matrix3d& rotation) {
    // The quaternion's vector part is well conditioned everywhere, its scalar part decides the angle.
    Eigen::Quaterniond q(rotation);
    q.normalize();
    if (q.w() < 0)
        q.coeffs() = -q.coeffs();
    const double sine = q.vec().norm();
    if (sine < 1e-12)
        return 2.0 * q.vec();
    return q.vec() * (2.0 * std::atan2(sine, q.w()) / sine);
}

RigidMotion exp(const Twist& twist) {
    const auto [a, b, c] = rotationCoefficients(twist.angular.squaredNorm());
    const Eigen::Matrix3d w = crossMatrix(twist.angular);
    const Eigen::Matrix3d v = Eigen::Matrix3d::Identity() + b * w + c * w * w;
    return {rotationExp(twist.angular), v * twist.linear};
}

Twist log(const RigidMotion& motion) {
    const Eigen::Vector3d angular = rotationLog(motion.rotation);
    const auto [a, b, c] = rotationCoefficients(angular.squaredNorm());
    const Eigen::Matrix3d w = crossMatrix(angular);
    const Eigen::Matrix3d v = Eigen::Matrix3d::Identity() + b * w + c * w * w;
    return {v.inverse() * motion.translation, angular};
}

bool isRotation(const Eigen::Matrix3d& rotation, double tolerance) {
    return rotation.allFinite() &&
           (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= tolerance &&
           rotation.determinant() > 0;
}

std::optional<Eigen::Matrix3d> nearestRotation(const Eigen::Matrix3d& matrix, double tolerance) {
    if (!isRotation(matrix, tolerance))
        return std::nullopt;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
}

} // namespace core
