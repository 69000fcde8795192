// SPDX-License-Identifier: MIT
#include "core/hand/triangle_mesh.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace core {

std::vector<Eigen::Vector3d> vertexNormals(const std::vector<Eigen::Vector3d>& vertices,
                                           const std::vector<std::array<int, 3>>& triangles) {
    std::vector<Eigen::Vector3d> normals(vertices.size(), Eigen::Vector3d::Zero());
    for (const auto& [a, b, c] : triangles) {
        const Eigen::Vector3d areaNormal = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
        normals[a] += areaNormal;
        normals[b] += areaNormal;
        normals[c] += areaNormal;
    }
    for (Eigen::Vector3d& normal : normals)
        normal.normalize();
    return normals;
}

std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh) {
    return vertexNormals(mesh.vertices, mesh.triangles);
}

std::vector<MeshEdge> meshEdges(const std::vector<std::array<int, 3>>& triangles) {
    struct HalfEdge {
        int low, high, triangle;
        auto key() const { return std::pair(low, high); }
    };
    std::vector<HalfEdge> halves;
    halves.reserve(3 * triangles.size());
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            halves.push_back({low, high, t});
        }
    }
    std::stable_sort(halves.begin(), halves.end(),
                     [](const HalfEdge& a, const HalfEdge& b) { return a.key() < b.key(); });
    std::vector<MeshEdge> edges;
    edges.reserve(halves.size() / 2);
    for (const HalfEdge& half : halves) {
        MeshEdge* last = edges.empty() ? nullptr : &edges.back();
        if (last && last->vertexA == half.low && last->vertexB == half.high && last->triangleB < 0)
            last->triangleB = half.triangle;
        else
            edges.push_back({half.low, half.high, half.triangle, -1});
    }
    return edges;
}

double signedVolume(const TriangleMesh& mesh) {
    double sixfold = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sixfold += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
    return sixfold / 6;
}

} // namespace core
