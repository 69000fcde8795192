// SPDX-License-Identifier: MIT
#include "core/fitting/recorded_pose.h"

#include "core/error.h"
#include "core/fitting/recorded_pose_problem.h"
#include "core/numeric/levenberg_marquardt.h"

namespace core {

namespace {

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

} // namespace

RecordedPoseFit fitRecordedPose(const Skeleton& skeleton, const std::vector<RigidMotion>& worldFromBone) {
    if (worldFromBone.size() != skeleton.bones.size())
        throw Error(ErrorCode::BadInput, "", "worldFromBone", "one pose per bone is expected");
    SolverOptions options;
    options.maxIterations = 30;
    options.minStep = 1e-9;
    options.initialDamping = 1e-6;
    options.minDamping = 1e-6;
    options.diagonalFloor = 1e-12;
    RecordedPoseFit fit{closedFormStart(skeleton, worldFromBone), {}};
    levenbergMarquardt(RecordedPoseProblem(skeleton, worldFromBone), options, fit.pose);
    const std::vector<Eigen::Vector3d> joints = jointPositions(skeleton, fit.pose);
    for (std::size_t b = 0; b < joints.size(); ++b)
        fit.originErrorMm.push_back((joints[b] - worldFromBone[b].translation).norm());
    return fit;
}

} // namespace core
