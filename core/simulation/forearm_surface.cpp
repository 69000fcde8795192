// SPDX-License-Identifier: MIT
#include "core/simulation/forearm_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

namespace core {

namespace {

constexpr int kSides = 32;
constexpr double kRingStepMm = 10;
constexpr double kOpeningMm = 260, kWristMm = 25, kElbowMm = 38; ///< along, radius, radius

/// From the hand towards the elbow: away from the knuckles of the four fingers, or from all joints where the model does
/// not name them.
Eigen::Vector3d armDirection(const Skeleton& skeleton, const std::vector<Eigen::Vector3d>& joints) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (const char* finger : {"index", "middle", "ring", "little"}) {
        const int bone = skeleton.boneIndex(std::string(finger) + "_mcp");
        if (bone < 0)
            continue;
        sum += joints[static_cast<std::size_t>(bone)];
        ++count;
    }
    if (count < 4) {
        sum = Eigen::Vector3d::Zero();
        count = 0;
        for (std::size_t b = 1; b < joints.size(); ++b, ++count)
            sum += joints[b];
    }
    const Eigen::Vector3d away = joints.front() - sum / std::max(count, 1);
    return away.norm() > 1e-6 ? Eigen::Vector3d(away.normalized()) : Eigen::Vector3d::UnitZ();
}

void addCap(ForearmSurface& arm, int firstOfRing, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
            bool isNear) {
    const auto middle = static_cast<int>(arm.verticesInWorld.size());
    arm.verticesInWorld.push_back(centre);
    arm.normalsInWorld.push_back(normal);
    for (int k = 0; k < kSides; ++k) {
        const int a = firstOfRing + k, b = firstOfRing + (k + 1) % kSides;
        arm.triangles.push_back(isNear ? std::array{middle, b, a} : std::array{middle, a, b});
    }
}

} // namespace

ForearmSurface forearmSurface(const HandModel& hand, const Pose& pose, double lengthMm) {
    const std::vector<Eigen::Vector3d> joints = jointPositions(hand.skeleton, pose);
    const Eigen::Vector3d axis = armDirection(hand.skeleton, joints);
    const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    ForearmSurface arm;
    const int rings = std::max(2, 1 + static_cast<int>(std::lround(lengthMm / kRingStepMm)));
    for (int ring = 0; ring < rings; ++ring) {
        const double along = lengthMm * ring / (rings - 1);
        const double radius = kWristMm + std::min(1.0, along / kOpeningMm) * (kElbowMm - kWristMm);
        for (int k = 0; k < kSides; ++k) {
            const double angle = 2 * std::numbers::pi * k / kSides;
            const Eigen::Vector3d outward = std::cos(angle) * u + std::sin(angle) * v;
            arm.verticesInWorld.push_back(joints.front() + along * axis + radius * outward);
            arm.normalsInWorld.push_back(outward);
            if (ring == 0)
                continue;
            const int a = (ring - 1) * kSides + k, b = (ring - 1) * kSides + (k + 1) % kSides;
            arm.triangles.push_back({a, b, b + kSides});
            arm.triangles.push_back({a, b + kSides, a + kSides});
        }
    }
    addCap(arm, 0, joints.front(), -axis, true);
    addCap(arm, (rings - 1) * kSides, joints.front() + lengthMm * axis, axis, false);
    return arm;
}

} // namespace core
