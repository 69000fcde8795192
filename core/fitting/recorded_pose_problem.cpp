// SPDX-License-Identifier: MIT
#include "core/fitting/recorded_pose_problem.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace core {

namespace {

constexpr double kLeastLeverMm = 10; ///< ends of shorter bones are taken this far out

Eigen::Vector3d endInBone(const Bone& bone) {
    return {std::max(bone.lengthMm, kLeastLeverMm), 0, 0};
}

/// moved[b][d]: whether degree of freedom d moves bone b.
std::vector<std::vector<bool>> movedBones(const Skeleton& skeleton) {
    std::vector<std::vector<bool>> moved(skeleton.bones.size(), std::vector<bool>(skeleton.dofs.size(), false));
    for (std::size_t b = 1; b < skeleton.bones.size(); ++b) {
        moved[b] = moved[static_cast<std::size_t>(skeleton.bones[b].parent)];
        for (std::size_t d = 0; d < skeleton.dofs.size(); ++d)
            moved[b][d] = moved[b][d] || skeleton.dofs[d].bone == static_cast<int>(b);
    }
    return moved;
}

} // namespace

RecordedPoseProblem::RecordedPoseProblem(const Skeleton& skeleton, const std::vector<RigidMotion>& worldFromBone)
    : m_skeleton(skeleton)
    , m_recorded(worldFromBone)
    , m_moved(movedBones(skeleton)) {}

Eigen::VectorXd RecordedPoseProblem::residuals(const Pose& pose) const {
    const std::vector<RigidMotion> bones = boneTransforms(m_skeleton, pose);
    Eigen::VectorXd residual(static_cast<Eigen::Index>(9 * bones.size()));
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const auto row = static_cast<Eigen::Index>(9 * b);
        const Eigen::Vector3d end = bones[b] * endInBone(m_skeleton.bones[b]);
        residual.segment<3>(row) = bones[b].translation - m_recorded[b].translation;
        residual.segment<3>(row + 3) = end - m_recorded[b] * endInBone(m_skeleton.bones[b]);
        residual.segment<3>(row + 6) =
            kRotationWeightMm * rotationLog(bones[b].rotation * m_recorded[b].rotation.transpose());
    }
    return residual;
}

Eigen::MatrixXd RecordedPoseProblem::jacobian(const Pose& pose) const {
    const std::vector<RigidMotion> bones = boneTransforms(m_skeleton, pose);
    const DofAxes axes = dofAxes(m_skeleton, pose);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(9 * bones.size()), pose.size());
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const auto row = static_cast<Eigen::Index>(9 * b);
        const Eigen::Vector3d end = bones[b] * endInBone(m_skeleton.bones[b]);
        for (Eigen::Index k = 0; k < pose.size(); ++k) {
            const auto index = static_cast<std::size_t>(k);
            const Eigen::Vector3d& axis = axes.axisInWorld[index];
            if (k < 3) {
                jacobian.block<3, 1>(row, k) = axis;
                jacobian.block<3, 1>(row + 3, k) = axis;
            } else if (k < kRigidDofs || m_moved[b][index - kRigidDofs]) {
                jacobian.block<3, 1>(row, k) = axis.cross(bones[b].translation - axes.pointInWorld[index]);
                jacobian.block<3, 1>(row + 3, k) = axis.cross(end - axes.pointInWorld[index]);
                jacobian.block<3, 1>(row + 6, k) = kRotationWeightMm * axis;
            }
        }
    }
    return jacobian;
}

void RecordedPoseProblem::linearise(const Pose& pose, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
    const Eigen::MatrixXd rows = jacobian(pose);
    hessian = rows.transpose() * rows;
    gradient = rows.transpose() * residuals(pose);
}

} // namespace core
