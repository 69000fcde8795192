// SPDX-License-Identifier: MIT
#include "core/hand/skinned_surface.h"

#include <algorithm>

#include <meshoptimizer.h>

namespace core {

namespace {

std::vector<unsigned> simplifiedIndices(const TriangleMesh& mesh, int targetVertices) {
    std::vector<unsigned> indices;
    indices.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles)
        for (int corner : triangle)
            indices.push_back(static_cast<unsigned>(corner));
    if (targetVertices <= 0 || targetVertices >= static_cast<int>(mesh.vertices.size()))
        return indices;
    std::vector<float> positions;
    positions.reserve(3 * mesh.vertices.size());
    for (const Eigen::Vector3d& v : mesh.vertices)
        for (int k = 0; k < 3; ++k)
            positions.push_back(static_cast<float>(v[k]));
    // A closed mesh has about twice as many triangles as vertices.
    const std::size_t targetIndices = 3 * 2 * static_cast<std::size_t>(targetVertices);
    constexpr float kMaxRelativeError = 0.05f;
    std::vector<unsigned> simplified(indices.size());
    simplified.resize(meshopt_simplify(simplified.data(), indices.data(), indices.size(), positions.data(),
                                       mesh.vertices.size(), 3 * sizeof(float), targetIndices, kMaxRelativeError, 0,
                                       nullptr));
    return simplified;
}

} // namespace

SkinnedSurface makeSkinnedSurface(const HandModel& hand, int targetVertices) {
    const std::vector<unsigned> indices = simplifiedIndices(hand.mesh, targetVertices);
    const std::vector<Eigen::Vector3d> normals = vertexNormals(hand.mesh);
    const SkinWeights weights = compressedWeights(hand.weights, 8, 1e-3);

    std::vector<int> levelIndex(hand.mesh.vertices.size(), -1);
    for (unsigned index : indices)
        levelIndex[index] = 0;
    SkinnedSurface surface;
    surface.firstWeight.push_back(0);
    for (std::size_t v = 0; v < levelIndex.size(); ++v) {
        if (levelIndex[v] < 0)
            continue;
        levelIndex[v] = static_cast<int>(surface.restPositions.size());
        surface.restPositions.push_back(hand.mesh.vertices[v].cast<float>());
        surface.restNormals.push_back(normals[v].cast<float>());
        for (int e = weights.firstEntry[v]; e < weights.firstEntry[v + 1]; ++e) {
            surface.weightBone.push_back(weights.entries[e].bone);
            surface.weightValue.push_back(static_cast<float>(weights.entries[e].weight));
        }
        surface.firstWeight.push_back(static_cast<int>(surface.weightBone.size()));
    }
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        surface.triangles.push_back({levelIndex[indices[i]], levelIndex[indices[i + 1]], levelIndex[indices[i + 2]]});
    for (const MeshEdge& edge : meshEdges(surface.triangles))
        surface.edges.push_back({edge.vertexA, edge.vertexB});
    return surface;
}

BoneMatrices boneMatrices(const Skeleton& skeleton, const Pose& pose) {
    const std::vector<RigidMotion> transforms = boneTransforms(skeleton, pose);
    BoneMatrices matrices;
    matrices.rows.resize(transforms.size());
    for (std::size_t b = 0; b < transforms.size(); ++b) {
        const RigidMotion worldFromRest = transforms[b] * inverse(skeleton.bones[b].worldFromBoneAtRest);
        auto& row = matrices.rows[b];
        row.fill(0);
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c)
                row[4 * r + c] = static_cast<float>(worldFromRest.rotation(r, c));
            row[4 * r + 3] = static_cast<float>(worldFromRest.translation[r]);
        }
    }
    return matrices;
}

void poseSurface(const SkinnedSurface& surface, const BoneMatrices& bones, PosedPoints& out) {
    const std::size_t count = surface.vertexCount();
    out.positions.resize(count);
    out.normals.resize(count);
    for (std::size_t v = 0; v < count; ++v) {
        alignas(32) float blended[16] = {};
        for (int e = surface.firstWeight[v]; e < surface.firstWeight[v + 1]; ++e) {
            const float weight = surface.weightValue[e];
            const float* matrix = bones.rows[surface.weightBone[e]].data();
            for (int i = 0; i < 16; ++i)
                blended[i] += weight * matrix[i];
        }
        const Eigen::Vector3f& p = surface.restPositions[v];
        const Eigen::Vector3f& n = surface.restNormals[v];
        for (int r = 0; r < 3; ++r) {
            const float* row = blended + 4 * r;
            out.positions[v][r] = row[0] * p.x() + row[1] * p.y() + row[2] * p.z() + row[3];
            out.normals[v][r] = row[0] * n.x() + row[1] * n.y() + row[2] * n.z();
        }
    }
}

} // namespace core
