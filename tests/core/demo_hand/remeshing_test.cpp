// SPDX-License-Identifier: MIT
#include "core/demo_hand/remeshing.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/shapes/mesh_checks.h"

namespace {

using Eigen::Vector3d;

const Eigen::AlignedBox3d kMeshedBox(Vector3d::Constant(-15), Vector3d::Constant(15));

double ball(const Vector3d& point) {
    return point.norm() - 10;
}

core::TriangleMesh fineSphere() {
    return core::polygonise(ball, kMeshedBox, 0.6, Vector3d::Zero());
}

TEST(Remeshing, MakesEvenTrianglesOfTheWantedSizeOnTheSurface) {
    const auto edgeLength = [](const Vector3d&) { return 2.0; };
    const core::TriangleMesh mesh = core::remeshed(ball, fineSphere(), edgeLength, 8);
    EXPECT_TRUE(test::isClosedAndOriented(mesh));
    EXPECT_EQ(test::eulerNumber(mesh), 2);
    EXPECT_NEAR(core::signedVolume(mesh), 4.0 / 3 * std::numbers::pi * 1000, 125); // inscribed
    double sum = 0;
    const std::vector<core::MeshEdge> edges = core::meshEdges(mesh.triangles);
    for (const core::MeshEdge& edge : edges) {
        const double length = (mesh.vertices[edge.vertexA] - mesh.vertices[edge.vertexB]).norm();
        EXPECT_GT(length, 1.0);
        EXPECT_LT(length, 4.0);
        sum += length;
    }
    EXPECT_NEAR(sum / static_cast<double>(edges.size()), 2.1, 0.4);
    for (const Vector3d& vertex : mesh.vertices)
        EXPECT_NEAR(ball(vertex), 0, 0.01);
}

TEST(Remeshing, FollowsAChangingEdgeLength) {
    const auto edgeLength = [](const Vector3d& point) { return point.z() > 0 ? 1.2 : 3.5; };
    const core::TriangleMesh mesh = core::remeshed(ball, fineSphere(), edgeLength, 6);
    EXPECT_TRUE(test::isClosedAndOriented(mesh));
    int above = 0, below = 0;
    for (const Vector3d& vertex : mesh.vertices) {
        above += vertex.z() > 2 ? 1 : 0;
        below += vertex.z() < -2 ? 1 : 0;
    }
    EXPECT_GT(above, 4 * below);
}

TEST(Remeshing, ATetrahedronCannotCollapse) {
    core::TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    ASSERT_TRUE(test::isClosedAndOriented(mesh));
    EXPECT_EQ(core::collapseShortEdges(mesh, [](const Vector3d&) { return 100.0; }), 0);
    EXPECT_EQ(core::flipEdges(mesh), 0);
    EXPECT_EQ(mesh.vertices.size(), 4U);
}

TEST(Remeshing, CollapsesKeepTheHoleOfARing) {
    const auto torus = [](const Vector3d& p) { return Eigen::Vector2d(p.head<2>().norm() - 8, p.z()).norm() - 3; };
    core::TriangleMesh mesh = core::polygonise(torus, kMeshedBox, 0.8, Vector3d(8, 0, 0));
    while (core::collapseShortEdges(mesh, [](const Vector3d&) { return 30.0; }) > 0) {
    }
    EXPECT_TRUE(test::isClosedAndOriented(mesh));
    EXPECT_EQ(test::eulerNumber(mesh), 0);
}

} // namespace
