// SPDX-License-Identifier: MIT
#include "core/subject/hand_shape.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr double kShortestMm = 1; ///< shorter stretches have no direction

double distanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
    const double u = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - from - u * along).norm();
}

} // namespace

ShapeSpace::ShapeSpace(HandModel model)
    : m_model(std::move(model))
    , m_normals(vertexNormals(m_model.mesh)) {
    collectSegments();
    m_directions.reserve(m_model.mesh.vertices.size());
    for (std::size_t v = 0; v < m_model.mesh.vertices.size(); ++v)
        m_directions.push_back(vertexDirections(static_cast<int>(v)));
}

void ShapeSpace::collectSegments() {
    const std::vector<Bone>& bones = m_model.skeleton.bones;
    std::vector<bool> isParent(bones.size(), false);
    for (std::size_t b = 1; b < bones.size(); ++b) {
        const auto parent = static_cast<std::size_t>(bones[b].parent);
        isParent[parent] = true;
        const Eigen::Vector3d along =
            bones[b].worldFromBoneAtRest.translation - bones[parent].worldFromBoneAtRest.translation;
        if (along.norm() >= kShortestMm)
            m_segments.push_back({bones[b].parent, static_cast<int>(b), along});
    }
    for (std::size_t b = 1; b < bones.size(); ++b) {
        if (!isParent[b] && bones[b].lengthMm >= kShortestMm) {
            m_segments.push_back(
                {static_cast<int>(b), -1, bones[b].lengthMm * bones[b].worldFromBoneAtRest.rotation.col(0)});
        }
    }
    m_segmentsOfBone.resize(bones.size());
    m_hangsOn.assign(bones.size(), std::vector<bool>(m_segments.size(), false));
    for (std::size_t a = 0; a < m_segments.size(); ++a) {
        m_segmentsOfBone[static_cast<std::size_t>(m_segments[a].bone)].push_back(static_cast<int>(a));
        for (std::size_t b = 0; b < bones.size(); ++b)
            for (int up = static_cast<int>(b); up >= 0; up = bones[static_cast<std::size_t>(up)].parent)
                m_hangsOn[b][a] = m_hangsOn[b][a] || up == m_segments[a].end;
    }
}

bool ShapeSpace::hangsOn(int bone, int segment) const {
    return m_hangsOn[static_cast<std::size_t>(bone)][static_cast<std::size_t>(segment)];
}

/// How much of the stretch a point of the segment's own bone takes part in: 0 at the origin, 1 at the end.
double ShapeSpace::stretchAt(int segment, const Eigen::Vector3d& pointAtRest) const {
    const ShapeSegment& s = m_segments[static_cast<std::size_t>(segment)];
    const Eigen::Vector3d& origin =
        m_model.skeleton.bones[static_cast<std::size_t>(s.bone)].worldFromBoneAtRest.translation;
    const double u = (pointAtRest - origin).dot(s.alongAtRest) / s.alongAtRest.squaredNorm();
    return std::clamp(u, 0.0, s.end < 0 ? 2.0 : 1.0);
}

/// Where several segments begin (the palm), each stretches what is near it.
double ShapeSpace::shareOf(int segment, const Eigen::Vector3d& pointAtRest) const {
    const auto bone = static_cast<std::size_t>(m_segments[static_cast<std::size_t>(segment)].bone);
    if (m_segmentsOfBone[bone].size() == 1)
        return 1;
    constexpr double kSoftMm2 = 25;
    const Eigen::Vector3d& origin = m_model.skeleton.bones[bone].worldFromBoneAtRest.translation;
    double sum = 0, own = 0;
    for (const int a : m_segmentsOfBone[bone]) {
        const double mm = distanceToSegment(pointAtRest, origin, m_segments[static_cast<std::size_t>(a)].alongAtRest);
        const double weight = 1 / (mm * mm + kSoftMm2);
        sum += weight;
        own += a == segment ? weight : 0;
    }
    return own / sum;
}

/// Per entry of the shape but the scale, what it does to a vertex before the scale is applied.
Eigen::Matrix3Xd ShapeSpace::vertexDirections(int vertex) const {
    Eigen::Matrix3Xd directions = Eigen::Matrix3Xd::Zero(3, size());
    const auto v = static_cast<std::size_t>(vertex);
    const Eigen::Vector3d& point = m_model.mesh.vertices[v];
    directions.col(1) = m_normals[v];
    for (int e = m_model.weights.firstEntry[v]; e < m_model.weights.firstEntry[v + 1]; ++e) {
        const SkinWeight& w = m_model.weights.entries[static_cast<std::size_t>(e)];
        directions.col(girthIndex(w.bone)) += w.weight * m_normals[v];
        for (int a = 0; a < segmentCount(); ++a)
            if (hangsOn(w.bone, a))
                directions.col(lengthIndex(a)) += w.weight * m_segments[static_cast<std::size_t>(a)].alongAtRest;
        for (const int a : m_segmentsOfBone[static_cast<std::size_t>(w.bone)]) {
            directions.col(lengthIndex(a)) += w.weight * shareOf(a, point) * stretchAt(a, point) *
                                              m_segments[static_cast<std::size_t>(a)].alongAtRest;
        }
    }
    return directions;
}

Eigen::Matrix3Xd ShapeSpace::originDirections(int bone) const {
    Eigen::Matrix3Xd directions = Eigen::Matrix3Xd::Zero(3, size());
    for (int a = 0; a < segmentCount(); ++a)
        if (hangsOn(bone, a))
            directions.col(lengthIndex(a)) = m_segments[static_cast<std::size_t>(a)].alongAtRest;
    return directions;
}

HandModel ShapeSpace::shaped(const HandShape& shape) const {
    HandModel hand = m_model;
    const double scale = std::exp(shape[0]);
    const Eigen::Vector3d& centre = m_model.skeleton.centreAtRest;
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v) {
        const Eigen::Vector3d changed = hand.mesh.vertices[v] + m_directions[v] * shape;
        hand.mesh.vertices[v] = centre + scale * (changed - centre);
    }
    for (int b = 0; b < boneCount(); ++b) {
        Bone& bone = hand.skeleton.bones[static_cast<std::size_t>(b)];
        const Eigen::Vector3d changed = bone.worldFromBoneAtRest.translation + originDirections(b) * shape;
        bone.worldFromBoneAtRest.translation = centre + scale * (changed - centre);
        const auto& segments = m_segmentsOfBone[static_cast<std::size_t>(b)];
        bone.lengthMm *= scale * (segments.empty() ? 1 : 1 + shape[lengthIndex(segments.front())]);
    }
    return hand;
}

double ShapeSpace::lengthMm(int segment, const HandShape& shape) const {
    return std::exp(shape[0]) * (1 + shape[lengthIndex(segment)]) *
           m_segments[static_cast<std::size_t>(segment)].alongAtRest.norm();
}

Eigen::Matrix3Xd ShapeSpace::vertexDerivative(int vertex, const HandShape& shape) const {
    Eigen::Matrix3Xd derivative = directionsOf(vertex);
    const Eigen::Vector3d fromCentre =
        m_model.mesh.vertices[static_cast<std::size_t>(vertex)] + derivative * shape - m_model.skeleton.centreAtRest;
    derivative.col(0) = fromCentre;
    return std::exp(shape[0]) * derivative;
}

Eigen::Matrix3Xd ShapeSpace::originDerivative(int bone, const HandShape& shape) const {
    Eigen::Matrix3Xd derivative = originDirections(bone);
    derivative.col(0) = m_model.skeleton.bones[static_cast<std::size_t>(bone)].worldFromBoneAtRest.translation +
                        derivative * shape - m_model.skeleton.centreAtRest;
    return std::exp(shape[0]) * derivative;
}

} // namespace core
