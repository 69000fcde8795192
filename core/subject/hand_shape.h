// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/hand/hand_model.h"

namespace core {

/// A stretch of the hand whose length can change: from the origin of `bone` to that of its child `end`, or, with
/// end = -1, from a last bone's origin along its x axis to its tip.
struct ShapeSegment {
    int bone = 0;
    int end = -1;
    Eigen::Vector3d alongAtRest = Eigen::Vector3d::Zero(); ///< from origin to end in the model's rest pose, mm
};

/// How a person's hand differs from the model, as one vector:
/// [0] logarithm of the overall scale, [1] girth in mm (offset of the surface along its normals), then per segment its
/// length's share beyond the scale (0.05 = 5 % longer than the scale alone says), then per bone the girth's difference
/// from [1] in mm, blended over the surface by the skinning weights.
using HandShape = Eigen::VectorXd;

/// The hands that a model can become: v' = c + s (v + sum_a rho_a D_a(v) + (g + sum_b w_b gamma_b) n(v) - c), c the
/// model's centre, n its unit normals, D_a what stretching segment a does to the rest pose: what hangs on its end moves
/// along, the bone itself stretches in proportion, blended by the skinning weights.
class ShapeSpace {
public:
    explicit ShapeSpace(HandModel model);

    const HandModel& model() const { return m_model; }
    const std::vector<ShapeSegment>& segments() const { return m_segments; }
    int size() const { return 2 + segmentCount() + boneCount(); }
    int segmentCount() const { return static_cast<int>(m_segments.size()); }
    int boneCount() const { return static_cast<int>(m_model.skeleton.bones.size()); }
    int lengthIndex(int segment) const { return 2 + segment; }
    int girthIndex(int bone) const { return 2 + segmentCount() + bone; }
    HandShape modelShape() const { return HandShape::Zero(size()); }

    /// The hand itself: same triangles, weights, degrees of freedom and centre, so that poses stay what they are.
    HandModel shaped(const HandShape& shape) const;
    /// Length of a segment in that shape, mm.
    double lengthMm(int segment, const HandShape& shape) const;

    /// Derivative of a vertex in the rest pose by the shape: 3 x size, mm.
    Eigen::Matrix3Xd vertexDerivative(int vertex, const HandShape& shape) const;
    /// Derivative of a bone's origin in the rest pose by the shape: 3 x size, mm.
    Eigen::Matrix3Xd originDerivative(int bone, const HandShape& shape) const;

private:
    void collectSegments();
    bool hangsOn(int bone, int segment) const;
    double stretchAt(int segment, const Eigen::Vector3d& pointAtRest) const;
    double shareOf(int segment, const Eigen::Vector3d& pointAtRest) const;
    Eigen::Matrix3Xd vertexDirections(int vertex) const;
    Eigen::Matrix3Xd originDirections(int bone) const;
    const Eigen::Matrix3Xd& directionsOf(int vertex) const { return m_directions[static_cast<std::size_t>(vertex)]; }

    HandModel m_model;
    std::vector<Eigen::Vector3d> m_normals;
    std::vector<ShapeSegment> m_segments;
    std::vector<std::vector<int>> m_segmentsOfBone; ///< by the bone where they begin
    std::vector<std::vector<bool>> m_hangsOn;       ///< [bone][segment]
    std::vector<Eigen::Matrix3Xd> m_directions;     ///< vertexDirections of every vertex: the same in every shape
};

} // namespace core
