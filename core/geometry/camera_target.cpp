// SPDX-License-Identifier: MIT
#include "core/geometry/camera_target.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace core {

namespace {

struct AxisEquations {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

AxisEquations axisEquations(const std::vector<Camera>& cameras) {
    AxisEquations equations;
    for (const Camera& camera : cameras) {
        const Eigen::Vector3d axis = camera.cameraFromWorld.rotation.row(2).transpose();
        const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
        equations.normal += across;
        equations.right += across * camera.centreInWorld();
    }
    return equations;
}

} // namespace

std::optional<Eigen::Vector3d> commonTarget(const std::vector<Camera>& cameras) {
    if (cameras.empty())
        return std::nullopt;
    const AxisEquations equations = axisEquations(cameras);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(equations.normal);
    constexpr double kLeastSpread = 1e-4; // smallest eigenvalue per camera of axes about half a degree apart
    if (solver.eigenvalues()[0] < kLeastSpread * static_cast<double>(cameras.size()))
        return std::nullopt;
    return equations.normal.ldlt().solve(equations.right);
}

Eigen::Vector3d commonTargetNearOrigin(const std::vector<Camera>& cameras) {
    constexpr double kTowardsOrigin = 1e-6;
    const AxisEquations equations = axisEquations(cameras);
    return (equations.normal + kTowardsOrigin * Eigen::Matrix3d::Identity()).ldlt().solve(equations.right);
}

} // namespace core
