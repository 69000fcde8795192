// SPDX-License-Identifier: MIT
#include "core/demo_hand/implicit_surface.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/shapes/mesh_checks.h"

namespace {

using Eigen::Vector3d;

const Eigen::AlignedBox3d kBox(Vector3d::Constant(-15), Vector3d::Constant(15));

double sphere(const Vector3d& point) {
    return (point - Vector3d(0.3, 0.2, -0.1)).norm() - 10;
}

double torus(const Vector3d& point) {
    return Eigen::Vector2d(point.head<2>().norm() - 8, point.z()).norm() - 3;
}

TEST(SmoothMin, IsTheMinimumFarFromTheSeamAndRoundsItOff) {
    EXPECT_DOUBLE_EQ(core::smoothMin(1, 9, 4), 1);
    EXPECT_DOUBLE_EQ(core::smoothMin(9, 1, 4), 1);
    EXPECT_DOUBLE_EQ(core::smoothMin(5, 5, 6), 4);
    EXPECT_DOUBLE_EQ(core::smoothMin(2, 3, 4), core::smoothMin(3, 2, 4));
}

TEST(Polygonise, ASphereIsClosedOrientedAndOfItsVolume) {
    const core::TriangleMesh mesh = core::polygonise(sphere, kBox, 0.7, Vector3d::Zero());
    EXPECT_TRUE(test::isClosedAndOriented(mesh));
    EXPECT_EQ(test::eulerNumber(mesh), 2);
    const double expected = 4.0 / 3 * std::numbers::pi * 1000;
    EXPECT_NEAR(core::signedVolume(mesh), expected, 0.01 * expected);
    for (const Vector3d& vertex : mesh.vertices)
        EXPECT_NEAR(sphere(vertex), 0, 0.1);
}

TEST(Polygonise, ARingKeepsItsHole) {
    const core::TriangleMesh mesh = core::polygonise(torus, kBox, 0.9, Vector3d(8, 0, 0));
    EXPECT_TRUE(test::isClosedAndOriented(mesh));
    EXPECT_EQ(test::eulerNumber(mesh), 0);
    EXPECT_NEAR(core::signedVolume(mesh), 2 * std::numbers::pi * std::numbers::pi * 8 * 9, 30);
}

TEST(Polygonise, SamplesExactlyOnTheSurfaceKeepTheMeshClosed) {
    const auto cube = [](const Vector3d& point) { return point.cwiseAbs().maxCoeff() - 5; };
    const core::TriangleMesh mesh = core::polygonise(cube, kBox, 1.0, Vector3d::Zero());
    EXPECT_TRUE(test::isClosedAndOriented(mesh));
    EXPECT_NEAR(core::signedVolume(mesh), 1000, 40);
}

TEST(Polygonise, GivesNoTrianglesAroundAPointOutside) {
    EXPECT_TRUE(core::polygonise(sphere, kBox, 0.7, Vector3d(13, 13, 13)).triangles.empty());
}

} // namespace
