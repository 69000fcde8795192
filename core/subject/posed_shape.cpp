// SPDX-License-Identifier: MIT
#include "core/subject/posed_shape.h"

#include <Eigen/Geometry>

namespace core {

PosedShape::PosedShape(const ShapeSpace& space, const HandModel& hand, const HandShape& shape, const Pose& pose)
    : m_space(space)
    , m_hand(hand)
    , m_shape(shape)
    , m_pose(pose)
    , m_worldFromBone(boneTransforms(hand.skeleton, pose)) {
    for (std::size_t b = 0; b < m_worldFromBone.size(); ++b)
        m_worldFromRest.push_back(m_worldFromBone[b] * inverse(hand.skeleton.bones[b].worldFromBoneAtRest));
}

Eigen::Vector3d PosedShape::vertex(int index) const {
    const auto v = static_cast<std::size_t>(index);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int e = m_hand.weights.firstEntry[v]; e < m_hand.weights.firstEntry[v + 1]; ++e) {
        const SkinWeight& w = m_hand.weights.entries[static_cast<std::size_t>(e)];
        sum += w.weight * (m_worldFromRest[static_cast<std::size_t>(w.bone)] * m_hand.mesh.vertices[v]);
    }
    return sum;
}

void PosedShape::linearise() {
    m_axes = dofAxes(m_hand.skeleton, m_pose);
    std::vector<Eigen::Matrix3Xd> atRest;
    for (int b = 0; b < m_space.boneCount(); ++b) {
        atRest.push_back(m_space.originDerivative(b, m_shape));
        const int parent = m_hand.skeleton.bones[static_cast<std::size_t>(b)].parent;
        const Eigen::Matrix3d& turn = m_worldFromRest[static_cast<std::size_t>(b)].rotation;
        if (parent < 0) {
            m_originByShape.emplace_back(turn * atRest.back());
        } else {
            const auto p = static_cast<std::size_t>(parent);
            m_originByShape.emplace_back(m_originByShape[p] +
                                         m_worldFromRest[p].rotation * (atRest.back() - atRest[p]));
        }
        m_offsetByShape.emplace_back(m_originByShape.back() - turn * atRest.back());
    }
}

void PosedShape::addPoseColumns(int bone, double weight, const Eigen::Vector3d& point,
                                Eigen::Matrix3Xd& derivative) const {
    for (int k = 0; k < 3; ++k) {
        derivative.col(k) += weight * m_axes.axisInWorld[static_cast<std::size_t>(k)];
        derivative.col(k + 3) += weight * m_axes.axisInWorld[static_cast<std::size_t>(k + 3)].cross(
                                              point - m_axes.pointInWorld[static_cast<std::size_t>(k + 3)]);
    }
    const Skeleton& skeleton = m_hand.skeleton;
    for (int up = bone; up >= 0; up = skeleton.bones[static_cast<std::size_t>(up)].parent) {
        for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
            if (skeleton.dofs[d].bone == up) {
                const std::size_t c = kRigidDofs + d;
                derivative.col(static_cast<Eigen::Index>(c)) +=
                    weight * m_axes.axisInWorld[c].cross(point - m_axes.pointInWorld[c]);
            }
        }
    }
}

Eigen::Matrix3Xd PosedShape::originDerivative(int bone) const {
    Eigen::Matrix3Xd derivative = Eigen::Matrix3Xd::Zero(3, m_pose.size() + m_shape.size());
    addPoseColumns(bone, 1, origin(bone), derivative);
    derivative.rightCols(m_shape.size()) = m_originByShape[static_cast<std::size_t>(bone)];
    return derivative;
}

Eigen::Matrix3Xd PosedShape::vertexDerivative(int index) const {
    const auto v = static_cast<std::size_t>(index);
    Eigen::Matrix3Xd derivative = Eigen::Matrix3Xd::Zero(3, m_pose.size() + m_shape.size());
    const Eigen::Matrix3Xd atRest = m_space.vertexDerivative(index, m_shape);
    for (int e = m_hand.weights.firstEntry[v]; e < m_hand.weights.firstEntry[v + 1]; ++e) {
        const SkinWeight& w = m_hand.weights.entries[static_cast<std::size_t>(e)];
        const auto b = static_cast<std::size_t>(w.bone);
        addPoseColumns(w.bone, w.weight, m_worldFromRest[b] * m_hand.mesh.vertices[v], derivative);
        derivative.rightCols(m_shape.size()) += w.weight * (m_offsetByShape[b] + m_worldFromRest[b].rotation * atRest);
    }
    return derivative;
}

} // namespace core
