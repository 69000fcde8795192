// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace core {

/// A closed triangle mesh, counter-clockwise from outside. Vertices in mm.
struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> triangles;
};

/// Area-weighted unit vertex normals, outward.
std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh);
std::vector<Eigen::Vector3d> vertexNormals(const std::vector<Eigen::Vector3d>& vertices,
                                           const std::vector<std::array<int, 3>>& triangles);

/// An undirected edge with the triangles on both sides (-1 where there is none).
struct MeshEdge {
    int vertexA, vertexB;
    int triangleA, triangleB;
};
std::vector<MeshEdge> meshEdges(const std::vector<std::array<int, 3>>& triangles);

/// Signed volume in mm^3 by the divergence theorem; positive for an outward oriented closed mesh.
double signedVolume(const TriangleMesh& mesh);

} // namespace core
