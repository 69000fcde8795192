// SPDX-License-Identifier: MIT
#include "tests/support/five_finger_skeleton.h"

namespace test {

core::Skeleton fiveFingerSkeleton(core::Side side) {
    core::Skeleton skeleton;
    const double mirror = side == core::Side::Right ? 1 : -1;
    const auto addBone = [&](const std::string& name, int parent, const Eigen::Vector3d& rightOrigin, double yawRad,
                             double lengthMm) {
        core::Bone bone;
        bone.name = name;
        bone.parent = parent;
        bone.worldFromBoneAtRest.translation = {rightOrigin.x(), mirror * rightOrigin.y(), rightOrigin.z()};
        bone.worldFromBoneAtRest.rotation = core::rotationExp({0, 0, mirror * yawRad});
        bone.lengthMm = lengthMm;
        skeleton.bones.push_back(bone);
        return static_cast<int>(skeleton.bones.size()) - 1;
    };
    const auto addDofs = [&](int bone, bool withAbduction) {
        const std::string& name = skeleton.bones[static_cast<std::size_t>(bone)].name;
        skeleton.dofs.push_back({name + ".flexion", bone, Eigen::Vector3d::UnitY(), -0.35, 1.7});
        if (withAbduction) {
            skeleton.dofs.push_back({name + ".abduction", bone, mirror * Eigen::Vector3d::UnitZ(), -0.4, 0.4});
        }
    };
    const int wrist = addBone("wrist", -1, {0, 0, 0}, 0, 90);
    struct Finger {
        std::string name;
        Eigen::Vector3d base;
        double yawRad;
        double lengthsMm[3];
        const char* joints[4];
    };
    const Finger fingers[] = {{"thumb", {25, 25, -8}, 0.8, {45, 32, 27}, {"cmc", "mcp", "ip", "tip"}},
                              {"index", {90, 30, 0}, 0.1, {42, 25, 20}, {"mcp", "pip", "dip", "tip"}},
                              {"middle", {94, 9, 1}, 0.0, {46, 28, 21}, {"mcp", "pip", "dip", "tip"}},
                              {"ring", {90, -11, 0}, -0.05, {43, 26, 21}, {"mcp", "pip", "dip", "tip"}},
                              {"little", {82, -29, -2}, -0.15, {34, 20, 19}, {"mcp", "pip", "dip", "tip"}}};
    for (const Finger& finger : fingers) {
        int parent = wrist;
        Eigen::Vector3d at = finger.base;
        for (int j = 0; j < 4; ++j) {
            const double length = j < 3 ? finger.lengthsMm[j] : 0;
            parent = addBone(finger.name + "_" + finger.joints[j], parent, at, finger.yawRad, length);
            at += length * Eigen::Vector3d(std::cos(finger.yawRad), std::sin(finger.yawRad), 0);
            if (j < 3)
                addDofs(parent, j == 0);
        }
    }
    skeleton.centreAtRest = {80, 0, 0};
    return skeleton;
}

core::Pose curledPose(const core::Skeleton& skeleton, double flexionRad) {
    core::Pose pose = skeleton.restPose();
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        const bool isFlexion = skeleton.dofs[d].name.ends_with(".flexion");
        pose[core::kRigidDofs + static_cast<Eigen::Index>(d)] = isFlexion ? flexionRad : 0.05;
    }
    return pose;
}

} // namespace test
