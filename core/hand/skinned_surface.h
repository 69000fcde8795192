// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/hand/hand_model.h"

namespace core {

/// A hand's surface prepared for many poses: a subset of the mesh's vertices with unit normals, in single precision and
/// row-compressed weights. A coarser level keeps the surface's shape with fewer vertices (edge collapse onto vertices
/// that exist, so weights and normals are those of the full mesh).
struct SkinnedSurface {
    std::vector<Eigen::Vector3f> restPositions; ///< mm
    std::vector<Eigen::Vector3f> restNormals;   ///< unit, outward
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> edges;
    std::vector<int> firstWeight; ///< as SkinWeights::firstEntry
    std::vector<int> weightBone;
    std::vector<float> weightValue;

    std::size_t vertexCount() const { return restPositions.size(); }
};

/// The level of `hand` with about `targetVertices` vertices; 0 or more than there are: the full mesh.
SkinnedSurface makeSkinnedSurface(const HandModel& hand, int targetVertices);

/// Positions (mm) and normals (not normalised) in the world, parallel to the surface's vertices.
struct PosedPoints {
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;
};

/// The transform of every bone from the rest pose, 3x4 row-major in single precision, padded to 16.
struct BoneMatrices {
    std::vector<std::array<float, 16>> rows;
};
BoneMatrices boneMatrices(const Skeleton& skeleton, const Pose& pose);

/// Linear blend skinning of the whole level. `out` is reused.
void poseSurface(const SkinnedSurface& surface, const BoneMatrices& bones, PosedPoints& out);

} // namespace core
