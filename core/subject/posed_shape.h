// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/subject/hand_shape.h"

namespace core {

/// A shaped hand in a pose, with the derivatives of its points by pose and shape.
/// With Q_b the rotation of bone b from rest to pose, t_b and o_b its origin at rest and posed, a vertex is
/// sum_b w_b (o_b + Q_b (v - t_b)); rotations do not depend on the shape, so that its derivative by the shape is
/// sum_b w_b (do_b + Q_b (dv - dt_b)), do_b = do_parent + Q_parent (dt_b - dt_parent).
class PosedShape {
public:
    /// `space` must outlive it; `hand` is space.shaped(shape) and must too.
    PosedShape(const ShapeSpace& space, const HandModel& hand, const HandShape& shape, const Pose& pose);

    Eigen::Vector3d origin(int bone) const { return m_worldFromBone[static_cast<std::size_t>(bone)].translation; }
    Eigen::Vector3d vertex(int index) const;
    /// 3 x (pose size + shape size): by the tangent step of retract, then by the shape.
    Eigen::Matrix3Xd originDerivative(int bone) const;
    Eigen::Matrix3Xd vertexDerivative(int index) const;
    /// Prepares the derivatives; without it only points can be asked for.
    void linearise();

private:
    void addPoseColumns(int bone, double weight, const Eigen::Vector3d& point, Eigen::Matrix3Xd& derivative) const;

    const ShapeSpace& m_space;
    const HandModel& m_hand;
    const HandShape& m_shape;
    const Pose& m_pose;
    std::vector<RigidMotion> m_worldFromBone;
    std::vector<RigidMotion> m_worldFromRest;
    DofAxes m_axes;
    std::vector<Eigen::Matrix3Xd> m_originByShape; ///< do_b
    std::vector<Eigen::Matrix3Xd> m_offsetByShape; ///< do_b - Q_b dt_b
};

} // namespace core
