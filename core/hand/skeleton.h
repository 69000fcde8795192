// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_motion.h"

namespace core {

/// Left or right hand.
enum class Side { Left, Right };
std::string_view sideName(Side side); ///< "left", "right"
std::optional<Side> sideFromName(std::string_view name);

/// A rigid part of the hand. Its origin is the joint `name` (wrist, thumb_cmc, index_mcp, index_pip, ...).
struct Bone {
    std::string name;
    int parent = -1;                 ///< index of the parent, smaller than the own index; -1 for the root (index 0)
    RigidMotion worldFromBoneAtRest; ///< pose in the rigging pose, in the mesh's frame, mm
    double lengthMm = 0;
};

/// A rotation of one bone about an axis fixed in that bone.
struct DegreeOfFreedom {
    std::string name;           ///< for people and rig files, such as "index_mcp.flexion"
    int bone = 0;               ///< index of the bone that it turns (never the root)
    Eigen::Vector3d axisInBone; ///< unit vector in the bone's own frame
    double minRad = 0;
    double maxRad = 0;
};

/// Pose of one hand: [0..2] translation of the hand's centre in mm, [3..5] rotation vector in rad about that centre,
/// [6..] one angle in rad per degree of freedom.
using Pose = Eigen::VectorXd;
inline constexpr int kRigidDofs = 6;

/// Tree of bones with one-axis degrees of freedom. Several degrees of freedom of one bone compose in their order:
/// parentFromBone(pose) = parentFromBone(rest) * exp(axis_1 angle_1) * exp(axis_2 angle_2) ...
/// The root: worldFromRoot(pose) = Translate(centre + pose[0..2]) * exp(pose[3..5]) * Translate(-centre) * rest.
struct Skeleton {
    std::vector<Bone> bones;
    std::vector<DegreeOfFreedom> dofs;                      ///< grouped by bone, bones in ascending order
    Eigen::Vector3d centreAtRest = Eigen::Vector3d::Zero(); ///< about which the whole hand turns

    int poseSize() const { return kRigidDofs + static_cast<int>(dofs.size()); }
    Pose restPose() const { return Pose::Zero(poseSize()); }
    /// Index of the bone of that name, or -1.
    int boneIndex(std::string_view name) const;
};

/// worldFromBone of every bone.
std::vector<RigidMotion> boneTransforms(const Skeleton& skeleton, const Pose& pose);
/// Origin of every bone in the world (mm): the hand's joints.
std::vector<Eigen::Vector3d> jointPositions(const Skeleton& skeleton, const Pose& pose);

/// pose moved by a tangent step: translation adds, exp(step[3..5]) multiplies the rotation from the left, angles add.
Pose retract(const Pose& pose, const Eigen::VectorXd& step);

/// Axis (unit) and a point on it, in the world, of every tangent direction; for the first three the axis is the
/// direction of translation and the point is unused.
struct DofAxes {
    std::vector<Eigen::Vector3d> axisInWorld;
    std::vector<Eigen::Vector3d> pointInWorld;
};
DofAxes dofAxes(const Skeleton& skeleton, const Pose& pose);

/// Derivative of the joint positions by the tangent step of `retract`: (3 * bones) x poseSize, mm per mm or rad.
Eigen::MatrixXd jointJacobian(const Skeleton& skeleton, const Pose& pose);

} // namespace core
