// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/hand/skeleton.h"

namespace core {

/// A joint of a rig: its name here, its parent, and what a hand model file may call it.
struct RigJoint {
    std::string name;
    std::string parent;                   ///< empty for the root, which comes first; else an earlier joint
    std::vector<std::string> namesInFile; ///< tried in order, {side} stands for "left" or "right"; none = `name`
};

/// One rotation of a joint. Axis in the anatomical frame of a right hand: x along the bone towards the fingertip, y
/// towards the thumb's side, z towards the back of the hand. A left hand turns the mirrored way, so that the same angle
/// is the same movement. Angles count from the model's rest pose.
struct RigDof {
    std::string joint;
    std::string name; ///< "flexion", "abduction", "twist"; the degree of freedom is named JOINT.NAME
    Eigen::Vector3d axis;
    double minDeg = 0;
    double maxDeg = 0;
};

/// What turns a set of joints into a skeleton with degrees of freedom.
struct Rig {
    std::string name;
    /// Directions, in a joint's own frame in the file, of the bone and of the back of the hand.
    Eigen::Vector3d forwardInJoint = Eigen::Vector3d::UnitX();
    Eigen::Vector3d dorsalInJoint = Eigen::Vector3d::UnitZ();
    std::vector<RigJoint> joints;
    std::vector<RigDof> dofs;
};

/// The anatomical frame at `origin`: x along `forward`, z as near to `dorsal` as that allows, y = z x x.
RigidMotion anatomicalFrame(const Eigen::Vector3d& origin, const Eigen::Vector3d& forward,
                            const Eigen::Vector3d& dorsal);

/// The skeleton of a hand whose joints have these anatomical frames at rest (parallel to rig.joints). The hand
/// turns about the middle of its joints. A bone's length is the distance to its first child, 0 at a tip.
Skeleton riggedSkeleton(const Rig& rig, Side side, const std::vector<RigidMotion>& worldFromJointAtRest);

} // namespace core
