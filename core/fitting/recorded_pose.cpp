// SPDX-License-Identifier: MIT
#include "core/fitting/recorded_pose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/error.h"

namespace core {

namespace {

constexpr int kMaxIterations = 30;
constexpr double kMinStep = 1e-9;       ///< the solver ends when no entry of a step (mm, rad) exceeds it
constexpr double kRotationWeightMm = 5; ///< 1 rad of rotation counts as much as this many mm
constexpr double kLeastLeverMm = 10;    ///< ends of shorter bones are taken this far out
constexpr double kDamping = 1e-6;       ///< relative to the diagonal

/// Rigid part from the root, angles from each bone's rotation relative to its parent.
Pose closedFormStart(const Skeleton& skeleton, const std::vector<RigidMotion>& worldFromBone) {
    Pose pose = skeleton.restPose();
    const RigidMotion worldFromRest = worldFromBone[0] * inverse(skeleton.bones[0].worldFromBoneAtRest);
    pose.segment<3>(3) = rotationLog(worldFromRest.rotation);
    pose.head<3>() = worldFromRest * skeleton.centreAtRest - skeleton.centreAtRest;
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        const auto bone = static_cast<std::size_t>(skeleton.dofs[d].bone);
        const auto parent = static_cast<std::size_t>(skeleton.bones[bone].parent);
        const Eigen::Matrix3d atRest = skeleton.bones[parent].worldFromBoneAtRest.rotation.transpose() *
                                       skeleton.bones[bone].worldFromBoneAtRest.rotation;
        const Eigen::Matrix3d now = worldFromBone[parent].rotation.transpose() * worldFromBone[bone].rotation;
        pose[kRigidDofs + static_cast<Eigen::Index>(d)] =
            skeleton.dofs[d].axisInBone.dot(rotationLog(atRest.transpose() * now));
    }
    return pose;
}

Eigen::Vector3d endInBone(const Bone& bone) {
    return {std::max(bone.lengthMm, kLeastLeverMm), 0, 0};
}

/// moved[b][d]: whether degree of freedom d moves bone b.
std::vector<std::vector<bool>> movedBones(const Skeleton& skeleton) {
    std::vector<std::vector<bool>> moved(skeleton.bones.size(), std::vector<bool>(skeleton.dofs.size(), false));
    for (std::size_t b = 1; b < skeleton.bones.size(); ++b) {
        moved[b] = moved[static_cast<std::size_t>(skeleton.bones[b].parent)];
        for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
            moved[b][d] = moved[b][d] || skeleton.dofs[d].bone == static_cast<int>(b);
        }
    }
    return moved;
}

/// Nine rows per bone: origin (mm), end (mm), rotation (weighted rad).
struct Linearisation {
    Eigen::MatrixXd jacobian;
    Eigen::VectorXd residual;
};

Linearisation linearise(const Skeleton& skeleton, const Pose& pose, const std::vector<RigidMotion>& recorded,
                        const std::vector<std::vector<bool>>& moved) {
    const std::vector<RigidMotion> bones = boneTransforms(skeleton, pose);
    const DofAxes axes = dofAxes(skeleton, pose);
    const auto rows = static_cast<Eigen::Index>(9 * bones.size());
    Linearisation system{Eigen::MatrixXd::Zero(rows, pose.size()), Eigen::VectorXd::Zero(rows)};
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const auto row = static_cast<Eigen::Index>(9 * b);
        const Eigen::Vector3d end = bones[b] * endInBone(skeleton.bones[b]);
        system.residual.segment<3>(row) = bones[b].translation - recorded[b].translation;
        system.residual.segment<3>(row + 3) = end - recorded[b] * endInBone(skeleton.bones[b]);
        system.residual.segment<3>(row + 6) =
            kRotationWeightMm * rotationLog(bones[b].rotation * recorded[b].rotation.transpose());
        for (Eigen::Index k = 0; k < pose.size(); ++k) {
            const auto index = static_cast<std::size_t>(k);
            const Eigen::Vector3d& axis = axes.axisInWorld[index];
            if (k < 3) {
                system.jacobian.block<3, 1>(row, k) = axis;
                system.jacobian.block<3, 1>(row + 3, k) = axis;
            } else if (k < kRigidDofs || moved[b][index - kRigidDofs]) {
                system.jacobian.block<3, 1>(row, k) = axis.cross(bones[b].translation - axes.pointInWorld[index]);
                system.jacobian.block<3, 1>(row + 3, k) = axis.cross(end - axes.pointInWorld[index]);
                system.jacobian.block<3, 1>(row + 6, k) = kRotationWeightMm * axis;
            }
        }
    }
    return system;
}

} // namespace

RecordedPoseFit fitRecordedPose(const Skeleton& skeleton, const std::vector<RigidMotion>& worldFromBone) {
    if (worldFromBone.size() != skeleton.bones.size()) {
        throw Error(ErrorCode::BadInput, "", "worldFromBone", "one pose per bone is expected");
    }
    const std::vector<std::vector<bool>> moved = movedBones(skeleton);
    RecordedPoseFit fit{closedFormStart(skeleton, worldFromBone), {}};
    Linearisation system = linearise(skeleton, fit.pose, worldFromBone, moved);
    double damping = kDamping;
    for (int i = 0; i < kMaxIterations; ++i) {
        Eigen::MatrixXd normal = system.jacobian.transpose() * system.jacobian;
        normal.diagonal() *= 1 + damping;
        normal.diagonal().array() += 1e-12;
        const Eigen::VectorXd step = -normal.ldlt().solve(system.jacobian.transpose() * system.residual);
        const Pose candidate = retract(fit.pose, step);
        Linearisation next = linearise(skeleton, candidate, worldFromBone, moved);
        if (next.residual.squaredNorm() <= system.residual.squaredNorm()) {
            fit.pose = candidate;
            system = std::move(next);
            damping = std::max(kDamping, damping / 10);
        } else {
            damping *= 10;
        }
        if (step.cwiseAbs().maxCoeff() < kMinStep) {
            break;
        }
    }
    const std::vector<Eigen::Vector3d> joints = jointPositions(skeleton, fit.pose);
    for (std::size_t b = 0; b < joints.size(); ++b) {
        fit.originErrorMm.push_back((joints[b] - worldFromBone[b].translation).norm());
    }
    return fit;
}

} // namespace core
