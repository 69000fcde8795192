// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

namespace core {

/// A proper rigid motion x_b = rotation * x_a + translation. Name instances `bFromA`. Translation in mm.
struct RigidMotion {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + translation; }
};

/// Composition: (cFromB * bFromA) = cFromA.
RigidMotion operator*(const RigidMotion& cFromB, const RigidMotion& bFromA);
RigidMotion inverse(const RigidMotion& bFromA);

/// The matrix [v]_x with [v]_x w = v x w.
Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v);

/// Rotation by |rotationVectorRad| about its direction (Rodrigues); exact to first order and better near 0.
Eigen::Matrix3d rotationExp(const Eigen::Vector3d& rotationVectorRad);
/// Inverse of rotationExp, in the ball of radius pi; stable near 0 and near pi.
Eigen::Vector3d rotationLog(const Eigen::Matrix3d& rotation);

/// Element of se(3): linear in mm, angular in rad (Murray, Li, Sastry 1994).
struct Twist {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};
RigidMotion exp(const Twist& twist);
Twist log(const RigidMotion& motion);

/// True if rotation is orthonormal with determinant +1, each within `tolerance`.
bool isRotation(const Eigen::Matrix3d& rotation, double tolerance = 1e-3);

/// The rotation nearest (Frobenius) to a matrix of few digits; empty if it is not one within `tolerance`.
std::optional<Eigen::Matrix3d> nearestRotation(const Eigen::Matrix3d& matrix, double tolerance);

} // namespace core
