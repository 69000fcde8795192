// SPDX-License-Identifier: MIT
#include "core/fitting/ray_equations.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace core {

void NormalEquations::reset(int size) {
    hessian.setZero(size, size);
    gradient.setZero(size);
    sumSquaredMm2 = 0;
    count = 0;
}

NormalEquations& NormalEquations::operator+=(const NormalEquations& other) {
    hessian += other.hessian;
    gradient += other.gradient;
    sumSquaredMm2 += other.sumSquaredMm2;
    count += other.count;
    return *this;
}

HandLinearisation::HandLinearisation(const HandModel& hand, const SkinnedSurface& surface, const Pose& pose)
    : m_surface(surface)
    , m_poseSize(hand.skeleton.poseSize()) {
    const Skeleton& skeleton = hand.skeleton;
    const std::vector<RigidMotion> worldFromBone = boneTransforms(skeleton, pose);
    for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
        m_parents.push_back(skeleton.bones[b].parent);
        const RigidMotion motion = worldFromBone[b] * inverse(skeleton.bones[b].worldFromBoneAtRest);
        Eigen::Matrix<double, 3, 4> matrix;
        matrix << motion.rotation, motion.translation;
        m_worldFromRest.push_back(matrix);
    }
    const DofAxes axes = dofAxes(skeleton, pose);
    for (int k = kRigidDofs; k < m_poseSize; ++k)
        m_dofBone.push_back(skeleton.dofs[static_cast<std::size_t>(k - kRigidDofs)].bone);
    for (int k = 0; k < m_poseSize; ++k) {
        m_axisX.push_back(axes.axisInWorld[k].x());
        m_axisY.push_back(axes.axisInWorld[k].y());
        m_axisZ.push_back(axes.axisInWorld[k].z());
        m_pointX.push_back(axes.pointInWorld[k].x());
        m_pointY.push_back(axes.pointInWorld[k].y());
        m_pointZ.push_back(axes.pointInWorld[k].z());
    }
}

void HandLinearisation::addVertex(int vertex, double factor, Carried& carried) const {
    const Eigen::Vector3d rest = m_surface.restPositions[vertex].cast<double>();
    for (int e = m_surface.firstWeight[vertex]; e < m_surface.firstWeight[vertex + 1]; ++e) {
        const int bone = m_surface.weightBone[e];
        const double weight = factor * static_cast<double>(m_surface.weightValue[e]);
        const Eigen::Vector3d s = weight * (m_worldFromRest[bone].leftCols<3>() * rest + m_worldFromRest[bone].col(3));
        carried.x[bone] += s.x();
        carried.y[bone] += s.y();
        carried.z[bone] += s.z();
        carried.weight[bone] += weight;
    }
}

void HandLinearisation::carry(int vertexA, int vertexB, double t, Carried& carried) const {
    for (auto* values : {&carried.x, &carried.y, &carried.z, &carried.weight})
        values->assign(m_parents.size(), 0.0);
    addVertex(vertexA, 1 - t, carried);
    addVertex(vertexB, t, carried);
    for (std::size_t b = m_parents.size(); b-- > 1;) {
        const int parent = m_parents[b];
        carried.x[parent] += carried.x[b];
        carried.y[parent] += carried.y[b];
        carried.z[parent] += carried.z[b];
        carried.weight[parent] += carried.weight[b];
    }
}

void HandLinearisation::writeRow(const Carried& carried, const Eigen::Vector3d& direction, double scale,
                                 double* row) const {
    const double dx = scale * direction.x(), dy = scale * direction.y(), dz = scale * direction.z();
    const auto turn = [&](int k, double ux, double uy, double uz) {
        return dx * (m_axisY[k] * uz - m_axisZ[k] * uy) + dy * (m_axisZ[k] * ux - m_axisX[k] * uz) +
               dz * (m_axisX[k] * uy - m_axisY[k] * ux);
    };
    row[0] = dx * carried.weight[0];
    row[1] = dy * carried.weight[0];
    row[2] = dz * carried.weight[0];
    for (int k = 3; k < kRigidDofs; ++k) {
        row[k] = turn(k, carried.x[0] - carried.weight[0] * m_pointX[k], carried.y[0] - carried.weight[0] * m_pointY[k],
                      carried.z[0] - carried.weight[0] * m_pointZ[k]);
    }
    for (int k = kRigidDofs; k < m_poseSize; ++k) {
        const int bone = m_dofBone[k - kRigidDofs];
        const double a = carried.weight[bone];
        row[k] = a == 0 ? 0
                        : turn(k, carried.x[bone] - a * m_pointX[k], carried.y[bone] - a * m_pointY[k],
                               carried.z[bone] - a * m_pointZ[k]);
    }
}

void HandLinearisation::accumulate(const std::vector<RayCorrespondence>& correspondences,
                                   NormalEquations& equations) const {
    constexpr Eigen::Index kBlock = 256;      // rows of one rank update: fits the first-level cache
    Eigen::MatrixXd rows(m_poseSize, kBlock); // one column per residual row
    Eigen::VectorXd residuals(kBlock);
    Carried carried;
    Eigen::Index used = 0;
    const auto flush = [&] {
        equations.hessian.selfadjointView<Eigen::Lower>().rankUpdate(rows.leftCols(used));
        equations.gradient.noalias() += rows.leftCols(used) * residuals.head(used);
        used = 0;
    };
    for (const RayCorrespondence& c : correspondences) {
        const Eigen::Vector3d offset = c.point - c.rayPoint;
        // n across the outline and d x n along it; a normal along the ray leaves the choice of n open.
        Eigen::Vector3d across = c.normal - c.normal.dot(c.rayDirection) * c.rayDirection;
        if (across.squaredNorm() < 1e-12)
            across = c.rayDirection.unitOrthogonal();
        across.normalize();
        const Eigen::Vector3d along = c.rayDirection.cross(across);
        const double scaleAcross = std::sqrt(c.weight), scaleAlong = std::sqrt(c.weight * c.tangentWeight);
        carry(c.vertexA, c.vertexB, c.t, carried);
        writeRow(carried, across, scaleAcross, rows.col(used).data());
        residuals[used++] = scaleAcross * across.dot(offset);
        if (scaleAlong > 0) {
            writeRow(carried, along, scaleAlong, rows.col(used).data());
            residuals[used++] = scaleAlong * along.dot(offset);
        }
        equations.sumSquaredMm2 += c.weight * (offset - offset.dot(c.rayDirection) * c.rayDirection).squaredNorm();
        ++equations.count;
        if (used + 2 > kBlock)
            flush();
    }
    flush();
    equations.hessian.triangularView<Eigen::StrictlyUpper>() = equations.hessian.transpose();
}

Eigen::MatrixXd HandLinearisation::pointJacobian(int vertexA, int vertexB, double t) const {
    Carried carried;
    carry(vertexA, vertexB, t, carried);
    Eigen::MatrixXd jacobian(3, m_poseSize);
    std::vector<double> row(static_cast<std::size_t>(m_poseSize));
    for (int axis = 0; axis < 3; ++axis) {
        writeRow(carried, Eigen::Vector3d::Unit(axis), 1, row.data());
        jacobian.row(axis) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), m_poseSize);
    }
    return jacobian;
}

} // namespace core
