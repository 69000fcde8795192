// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/pluecker_line.h"
#include "core/hand/hand_model.h"
#include "core/hand/skinned_surface.h"

namespace core {

/// A point v on an edge of a hand's surface and the projection ray (d, m = c x d) that it should lie on: the residual
/// is v x d - m, whose length is the distance of v from the ray (docs/method.md, "Pose from matches").
struct RayCorrespondence {
    int vertexA = 0; ///< indices into the surface
    int vertexB = 0;
    double t = 0;                 ///< the point is (1 - t) A + t B
    Eigen::Vector3d point;        ///< current position in the world, mm (bulge of the rim included)
    Eigen::Vector3d rayPoint;     ///< any point of the ray, for instance the camera's centre
    Eigen::Vector3d rayDirection; ///< unit
    Eigen::Vector3d normal;       ///< outward surface normal at the point
    double weight = 1;            ///< of the squared distance
    double tangentWeight = 1;     ///< extra factor on the part of the distance along the outline; 1 = the full distance
};

/// H s = -g, the minimum of sum_i w_i |v_i(s) x d_i - m_i|^2 / 2 with v_i(s) linearised at the current pose: H = J^T J,
/// g = J^T r. v x d - m has rank 2, so J and r have two rows per correspondence, along two unit vectors perpendicular
/// to d: n across the outline, the normalised part of the surface normal perpendicular to d, and d x n along it,
///     r = (sqrt(w) n . (v - c), sqrt(w t) (d x n) . (v - c)),
/// t = tangentWeight. With t = 1 the sum of squares is that of the three rows of the cross product.
struct NormalEquations {
    Eigen::MatrixXd hessian;
    Eigen::VectorXd gradient;
    double sumSquaredMm2 = 0; ///< sum of w_i |v_i x d_i - m_i|^2
    int count = 0;

    void reset(int size);
    NormalEquations& operator+=(const NormalEquations& other);
};

/// What the Jacobians of one hand in one pose need: bone transforms and degree-of-freedom axes.
/// The derivative of v by degree of freedom k with the current axis w_k through q_k is w_k x (S_k - a_k q_k), S_k = sum
/// over the bones b below k of a_vb T_b v, a_k = the sum of their weights a_vb. Exact for a point fixed on the surface;
/// that the rim wanders over the surface as the hand turns is left out, the rim is extracted again after the step.
class HandLinearisation {
public:
    HandLinearisation(const HandModel& hand, const SkinnedSurface& surface, const Pose& pose);

    /// Adds the correspondences in order; results do not depend on how they are split over calls.
    void accumulate(const std::vector<RayCorrespondence>& correspondences, NormalEquations& equations) const;
    /// 3 x poseSize derivative of the point (1 - t) A + t B by the tangent step of retract.
    Eigen::MatrixXd pointJacobian(int vertexA, int vertexB, double t) const;
    int poseSize() const { return m_poseSize; }

private:
    struct Carried {
        std::vector<double> x, y, z, weight; ///< per bone: S and a, summed over the subtree
    };
    void carry(int vertexA, int vertexB, double t, Carried& carried) const;
    void addVertex(int vertex, double factor, Carried& carried) const;
    /// row[k] = scale * direction . (w_k x (S_k - a_k q_k)); for the translations, scale * direction * a_0.
    void writeRow(const Carried& carried, const Eigen::Vector3d& direction, double scale, double* row) const;

    const SkinnedSurface& m_surface;
    int m_poseSize;
    std::vector<int> m_parents;
    std::vector<Eigen::Matrix<double, 3, 4>> m_worldFromRest;
    std::vector<int> m_dofBone;
    std::vector<double> m_axisX, m_axisY, m_axisZ, m_pointX, m_pointY, m_pointZ;
};

} // namespace core
