// SPDX-License-Identifier: MIT
#include "core/hand/skeleton.h"

#include <Eigen/Geometry>

namespace core {

std::string_view sideName(Side side) {
    return side == Side::Left ? "left" : "right";
}

std::optional<Side> sideFromName(std::string_view name) {
    if (name == "left")
        return Side::Left;
    if (name == "right")
        return Side::Right;
    return std::nullopt;
}

int Skeleton::boneIndex(std::string_view name) const {
    for (std::size_t i = 0; i < bones.size(); ++i)
        if (bones[i].name == name)
            return static_cast<int>(i);
    return -1;
}

namespace {

RigidMotion rootTransform(const Skeleton& skeleton, const Pose& pose) {
    const Eigen::Matrix3d rotation = rotationExp(pose.segment<3>(3));
    const RigidMotion worldFromRest{rotation,
                                    skeleton.centreAtRest + pose.head<3>() - rotation * skeleton.centreAtRest};
    return worldFromRest * skeleton.bones.front().worldFromBoneAtRest;
}

/// worldFromBone of every bone, parents first; visitDof(index, axis in the world, point on it) on the way.
template <typename VisitDof>
std::vector<RigidMotion> walk(const Skeleton& skeleton, const Pose& pose, VisitDof&& visitDof) {
    std::vector<RigidMotion> worldFromBone(skeleton.bones.size());
    std::size_t dof = 0;
    for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
        const Bone& bone = skeleton.bones[b];
        if (bone.parent < 0) {
            worldFromBone[b] = rootTransform(skeleton, pose);
            continue;
        }
        const RigidMotion parentFromRest =
            inverse(skeleton.bones[bone.parent].worldFromBoneAtRest) * bone.worldFromBoneAtRest;
        RigidMotion current = worldFromBone[bone.parent] * parentFromRest;
        for (; dof < skeleton.dofs.size() && skeleton.dofs[dof].bone == static_cast<int>(b); ++dof) {
            const DegreeOfFreedom& axis = skeleton.dofs[dof];
            visitDof(dof, Eigen::Vector3d(current.rotation * axis.axisInBone), current.translation);
            current.rotation *= rotationExp(axis.axisInBone * pose[kRigidDofs + static_cast<Eigen::Index>(dof)]);
        }
        worldFromBone[b] = current;
    }
    return worldFromBone;
}

} // namespace

std::vector<RigidMotion> boneTransforms(const Skeleton& skeleton, const Pose& pose) {
    return walk(
        skeleton, pose, [](std::size_t, const Eigen::Vector3d&, const Eigen::Vector3d&) {});
}

std::vector<Eigen::Vector3d> jointPositions(const Skeleton& skeleton, const Pose& pose) {
    std::vector<Eigen::Vector3d> joints;
    joints.reserve(skeleton.bones.size());
    for (const RigidMotion& worldFromBone : boneTransforms(skeleton, pose))
        joints.push_back(worldFromBone.translation);
    return joints;
}

Pose retract(const Pose& pose, const Eigen::VectorXd& step) {
    Pose result = pose + step;
    result.segment<3>(3) = rotationLog(rotationExp(step.segment<3>(3)) * rotationExp(pose.segment<3>(3)));
    return result;
}

DofAxes dofAxes(const Skeleton& skeleton, const Pose& pose) {
    DofAxes axes;
    axes.axisInWorld.resize(skeleton.poseSize());
    axes.pointInWorld.resize(skeleton.poseSize());
    const Eigen::Vector3d centre = skeleton.centreAtRest + pose.head<3>();
    for (int k = 0; k < 3; ++k) {
        axes.axisInWorld[k] = axes.axisInWorld[k + 3] = Eigen::Vector3d::Unit(k);
        axes.pointInWorld[k] = axes.pointInWorld[k + 3] = centre;
    }
    walk(skeleton, pose, [&](std::size_t dof, const Eigen::Vector3d& axis, const Eigen::Vector3d& point) {
        axes.axisInWorld[kRigidDofs + dof] = axis;
        axes.pointInWorld[kRigidDofs + dof] = point;
    });
    return axes;
}

Eigen::MatrixXd jointJacobian(const Skeleton& skeleton, const Pose& pose) {
    const std::vector<RigidMotion> worldFromBone = boneTransforms(skeleton, pose);
    const DofAxes axes = dofAxes(skeleton, pose);
    const auto boneCount = static_cast<Eigen::Index>(skeleton.bones.size());
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3 * boneCount, skeleton.poseSize());
    for (Eigen::Index b = 0; b < boneCount; ++b) {
        const Eigen::Vector3d& joint = worldFromBone[b].translation;
        for (int k = 0; k < 3; ++k) {
            jacobian.block<3, 1>(3 * b, k) = axes.axisInWorld[k];
            jacobian.block<3, 1>(3 * b, k + 3) = axes.axisInWorld[k + 3].cross(joint - axes.pointInWorld[k + 3]);
        }
        for (int ancestor = static_cast<int>(b); ancestor >= 0; ancestor = skeleton.bones[ancestor].parent) {
            for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
                if (skeleton.dofs[d].bone == ancestor) {
                    const std::size_t column = kRigidDofs + d;
                    jacobian.block<3, 1>(3 * b, static_cast<Eigen::Index>(column)) =
                        axes.axisInWorld[column].cross(joint - axes.pointInWorld[column]);
                }
            }
        }
    }
    return jacobian;
}

} // namespace core
