// SPDX-License-Identifier: MIT
#include "core/hand/skinned_surface.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/two_finger_hand.h"

namespace {

using core::HandModel;
using core::Pose;
using core::PosedPoints;
using core::SkinnedSurface;
using Eigen::Vector3d;

HandModel makeSurfaceHand() {
    return test::twoFingerHand(core::Side::Left, core::exp({{150, -80, 600}, {0.4, -0.2, 1}}));
}

PosedPoints posed(const SkinnedSurface& surface, const HandModel& hand, const Pose& pose) {
    PosedPoints points;
    core::poseSurface(surface, core::boneMatrices(hand.skeleton, pose), points);
    return points;
}

double distanceFromSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - (a + t * (b - a))).norm();
}

double distanceFromTriangle(const Vector3d& p, const std::array<Vector3d, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Vector3d normal = (b - a).cross(c - a);
    const auto isLeftOf = [&](const Vector3d& from, const Vector3d& to) {
        return (to - from).cross(p - from).dot(normal) >= 0;
    };
    if (isLeftOf(a, b) && isLeftOf(b, c) && isLeftOf(c, a))
        return std::abs((p - a).dot(normal)) / normal.norm();
    return std::min({distanceFromSegment(p, a, b), distanceFromSegment(p, b, c), distanceFromSegment(p, c, a)});
}

TEST(SkinnedSurface, TheFullLevelIsThePosedMesh) {
    const HandModel hand = makeSurfaceHand();
    const SkinnedSurface surface = core::makeSkinnedSurface(hand, 0);
    HandModel compressed = hand;
    compressed.weights = core::compressedWeights(hand.weights, 8, 1e-3);
    ASSERT_EQ(surface.vertexCount(), hand.mesh.vertices.size());
    EXPECT_EQ(surface.triangles, hand.mesh.triangles);
    test::RandomValues random("full level");
    for (int trial = 0; trial < 5; ++trial) {
        const Pose pose = test::somePose(hand.skeleton, random, 100, 2.5);
        const std::vector<Vector3d> all = core::posedVertices(hand, pose),
                                    oracle = core::posedVertices(compressed, pose);
        const PosedPoints points = posed(surface, hand, pose);
        for (std::size_t v = 0; v < oracle.size(); ++v) {
            ASSERT_LT((points.positions[v].cast<double>() - oracle[v]).norm(), 5e-4) << "single precision";
            ASSERT_LT((points.positions[v].cast<double>() - all[v]).norm(), 0.02) << "small weights are left out";
        }
    }
}

TEST(SkinnedSurface, NormalsTurnWithTheBones) {
    const HandModel hand = makeSurfaceHand();
    const SkinnedSurface surface = core::makeSkinnedSurface(hand, 0);
    Pose pose = hand.skeleton.restPose();
    pose.head<6>() << 20, -30, 5, 0.5, 1.2, -0.4;
    const std::vector<Vector3d> oracle = core::vertexNormals(core::posedVertices(hand, pose), hand.mesh.triangles);
    const PosedPoints points = posed(surface, hand, pose);
    for (std::size_t v = 0; v < oracle.size(); ++v)
        ASSERT_LT((points.normals[v].cast<double>() - oracle[v]).norm(), 1e-4);
}

TEST(SkinnedSurface, NormalsOfABentHandAreThoseOfItsSkinButNearJoints) {
    const HandModel hand = makeSurfaceHand();
    const SkinnedSurface surface = core::makeSkinnedSurface(hand, 0);
    test::RandomValues random("bent normals");
    const Pose pose = test::somePose(hand.skeleton, random);
    const std::vector<Vector3d> oracle = core::vertexNormals(core::posedVertices(hand, pose), hand.mesh.triangles);
    const PosedPoints points = posed(surface, hand, pose);
    std::vector<double> errors;
    for (std::size_t v = 0; v < oracle.size(); ++v)
        errors.push_back(std::acos(std::min(1.0, points.normals[v].cast<double>().normalized().dot(oracle[v]))));
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 0.01);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.35);
}

TEST(SkinnedSurface, CoarserLevelsKeepVerticesOfTheMesh) {
    const HandModel hand = makeSurfaceHand();
    const std::vector<Vector3d> normals = core::vertexNormals(hand.mesh);
    for (const int target : {700, 300}) {
        const SkinnedSurface surface = core::makeSkinnedSurface(hand, target);
        EXPECT_LT(static_cast<int>(surface.vertexCount()), target * 11 / 10);
        EXPECT_GT(static_cast<int>(surface.vertexCount()), target / 2);
        for (std::size_t v = 0; v < surface.vertexCount(); ++v) {
            const auto found =
                std::find_if(hand.mesh.vertices.begin(), hand.mesh.vertices.end(), [&](const Vector3d& p) {
                    return (p.cast<float>() - surface.restPositions[v]).norm() == 0;
                });
            ASSERT_NE(found, hand.mesh.vertices.end());
            const Vector3d& normal = normals[static_cast<std::size_t>(found - hand.mesh.vertices.begin())];
            EXPECT_LT((surface.restNormals[v].cast<double>() - normal).norm(), 1e-6);
        }
    }
}

TEST(SkinnedSurface, CoarserLevelsAreWellFormed) {
    const HandModel hand = makeSurfaceHand();
    for (const int target : {0, 700, 300}) {
        const SkinnedSurface surface = core::makeSkinnedSurface(hand, target);
        ASSERT_EQ(surface.restNormals.size(), surface.vertexCount());
        ASSERT_EQ(surface.firstWeight.size(), surface.vertexCount() + 1);
        std::set<std::pair<int, int>> edges;
        for (const auto& triangle : surface.triangles) {
            for (int k = 0; k < 3; ++k) {
                ASSERT_LT(static_cast<std::size_t>(triangle[k]), surface.vertexCount());
                edges.insert(std::minmax(triangle[k], triangle[(k + 1) % 3]));
            }
        }
        EXPECT_EQ(surface.edges.size(), edges.size());
        for (const auto& [a, b] : surface.edges)
            EXPECT_TRUE(edges.contains(std::minmax(a, b)));
        for (std::size_t v = 0; v < surface.vertexCount(); ++v) {
            float sum = 0;
            for (int e = surface.firstWeight[v]; e < surface.firstWeight[v + 1]; ++e)
                sum += surface.weightValue[static_cast<std::size_t>(e)];
            EXPECT_NEAR(sum, 1, 1e-5);
        }
    }
}

TEST(SkinnedSurface, CoarserLevelsStayNearTheMesh) {
    const HandModel hand = makeSurfaceHand();
    const SkinnedSurface surface = core::makeSkinnedSurface(hand, 700);
    double sum = 0, most = 0;
    int count = 0;
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); v += 7) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& triangle : surface.triangles) {
            std::array<Vector3d, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = surface.restPositions[static_cast<std::size_t>(triangle[k])].cast<double>();
            least = std::min(least, distanceFromTriangle(hand.mesh.vertices[v], corners));
        }
        sum += least;
        most = std::max(most, least);
        ++count;
    }
    EXPECT_LT(sum / count, 0.6);
    EXPECT_LT(most, 3);
}

TEST(SkinnedSurface, AsManyVerticesAsThereAreOrMoreIsTheFullMesh) {
    const HandModel hand = makeSurfaceHand();
    const int all = static_cast<int>(hand.mesh.vertices.size());
    EXPECT_EQ(core::makeSkinnedSurface(hand, all).vertexCount(), hand.mesh.vertices.size());
    EXPECT_EQ(core::makeSkinnedSurface(hand, 10 * all).vertexCount(), hand.mesh.vertices.size());
}

} // namespace
