// SPDX-License-Identifier: MIT
#include "core/hand/rig.h"

#include <numbers>

#include <Eigen/Geometry>

namespace core {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

/// A rotation axis is mirrored as a moment, not as a direction: what lies in the mirror (x and z) changes sign.
Eigen::Vector3d axisOnSide(const Eigen::Vector3d& axisOnRight, Side side) {
    return side == Side::Right ? axisOnRight : Eigen::Vector3d(-axisOnRight.x(), axisOnRight.y(), -axisOnRight.z());
}

void setLengths(std::vector<Bone>& bones) {
    for (std::size_t b = bones.size(); b-- > 1;) {
        Bone& parent = bones[static_cast<std::size_t>(bones[b].parent)];
        parent.lengthMm = (bones[b].worldFromBoneAtRest.translation - parent.worldFromBoneAtRest.translation).norm();
    }
}

} // namespace

RigidMotion anatomicalFrame(const Eigen::Vector3d& origin, const Eigen::Vector3d& forward,
                            const Eigen::Vector3d& dorsal) {
    const Eigen::Vector3d x = forward.normalized();
    const Eigen::Vector3d y = dorsal.cross(x).normalized();
    RigidMotion frame;
    frame.rotation << x, y, x.cross(y);
    frame.translation = origin;
    return frame;
}

Skeleton riggedSkeleton(const Rig& rig, Side side, const std::vector<RigidMotion>& worldFromJointAtRest) {
    Skeleton skeleton;
    for (std::size_t j = 0; j < rig.joints.size(); ++j) {
        const RigJoint& joint = rig.joints[j];
        skeleton.bones.push_back({joint.name, skeleton.boneIndex(joint.parent), worldFromJointAtRest[j], 0});
        skeleton.centreAtRest += worldFromJointAtRest[j].translation / static_cast<double>(rig.joints.size());
    }
    setLengths(skeleton.bones);
    for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
        for (const RigDof& dof : rig.dofs) {
            if (dof.joint == skeleton.bones[b].name) {
                skeleton.dofs.push_back({dof.joint + "." + dof.name, static_cast<int>(b),
                                         axisOnSide(dof.axis.normalized(), side), dof.minDeg * kRadPerDeg,
                                         dof.maxDeg * kRadPerDeg});
            }
        }
    }
    return skeleton;
}

} // namespace core
