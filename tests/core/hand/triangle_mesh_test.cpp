// SPDX-License-Identifier: MIT
#include "core/hand/triangle_mesh.h"

#include <map>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/random_values.h"
#include "tests/support/shapes/solids.h"

namespace {

using core::MeshEdge;
using core::TriangleMesh;
using Eigen::Vector3d;

TEST(TriangleMesh, NormalsOfABallPointFromItsCentre) {
    const Vector3d centre(5, -20, 300);
    const TriangleMesh mesh = test::ball(centre, 40, 24, 48);
    const std::vector<Vector3d> normals = core::vertexNormals(mesh);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        EXPECT_NEAR(normals[v].norm(), 1, 1e-12);
        EXPECT_GT(normals[v].dot((mesh.vertices[v] - centre).normalized()), std::cos(0.03));
    }
}

TEST(TriangleMesh, NormalsAreWeightedByArea) {
    // A pyramid's top: three walls of which one is larger.
    const std::vector<Vector3d> vertices{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-3, -3, 0}};
    const std::vector<std::array<int, 3>> walls{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
    Vector3d sum = Vector3d::Zero();
    for (const auto& [a, b, c] : walls) {
        const Vector3d normal = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
        sum += 0.5 * normal.norm() * normal.normalized(); // area times unit normal
    }
    EXPECT_TRUE(core::vertexNormals(vertices, walls)[0].isApprox(sum.normalized(), 1e-12));
}

TEST(TriangleMesh, EveryEdgeOfAClosedMeshJoinsTwoTriangles) {
    const TriangleMesh mesh = test::capsule(60, 10, 5, 12);
    const std::vector<MeshEdge> edges = core::meshEdges(mesh.triangles);
    std::map<std::pair<int, int>, std::set<int>> oracle;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            oracle[{std::min(a, b), std::max(a, b)}].insert(t);
        }
    }
    ASSERT_EQ(edges.size(), oracle.size());
    for (const MeshEdge& edge : edges) {
        EXPECT_LT(edge.vertexA, edge.vertexB);
        const std::set<int> triangles{edge.triangleA, edge.triangleB};
        EXPECT_EQ((oracle[{edge.vertexA, edge.vertexB}]), triangles);
    }
    EXPECT_EQ(mesh.vertices.size() - edges.size() + mesh.triangles.size(), 2u) << "Euler's formula";
}

TEST(TriangleMesh, EdgesOfAnOpenMeshHaveOneTriangle) {
    const std::vector<MeshEdge> edges = core::meshEdges({{0, 1, 2}, {2, 1, 3}});
    ASSERT_EQ(edges.size(), 5u);
    for (const MeshEdge& edge : edges) {
        const bool shared = edge.vertexA == 1 && edge.vertexB == 2;
        EXPECT_EQ(edge.triangleB >= 0, shared);
    }
    EXPECT_TRUE(core::meshEdges({}).empty());
}

TEST(TriangleMesh, VolumeIsThatOfTheSolidWhereverItLies) {
    TriangleMesh box;
    for (int corner = 0; corner < 8; ++corner)
        box.vertices.emplace_back(corner & 1 ? 7 : 2, corner & 2 ? 4 : 1, corner & 4 ? 13 : 3);
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    EXPECT_NEAR(core::signedVolume(box), 5 * 3 * 10, 1e-10);
    EXPECT_NEAR(core::signedVolume(test::moved(box, {core::rotationExp({1, 2, 0.3}), {900, -80, 400}})), 150, 1e-6);
    for (auto& triangle : box.triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(core::signedVolume(box), -150, 1e-10);
    const double ball = 4.0 / 3 * std::numbers::pi * 1000;
    EXPECT_NEAR(core::signedVolume(test::ball({1, 2, 3}, 10)), ball, 0.005 * ball);
}

} // namespace
