// SPDX-License-Identifier: MIT
#include "core/hand/mesh_repair.h"

#include <gtest/gtest.h>

#include "tests/support/shapes/mesh_checks.h"
#include "tests/support/tiny_hands.h"

namespace {

using core::WeightedSurface;

/// Every triangle with corners of its own, all on bone 0, but with z > 0 half on bone 1.
WeightedSurface exploded(const core::TriangleMesh& mesh) {
    WeightedSurface surface{{}, {{0}, {}}};
    for (const auto& t : mesh.triangles) {
        const int first = static_cast<int>(surface.mesh.vertices.size());
        surface.mesh.triangles.push_back({first, first + 1, first + 2});
        for (const int v : t) {
            surface.mesh.vertices.push_back(mesh.vertices[v] + Eigen::Vector3d::Constant(1e-5 * (first % 3)));
            const bool isUp = mesh.vertices[v].z() > 0;
            surface.weights.entries.push_back({0, isUp ? 0.5 : 1.0});
            if (isUp)
                surface.weights.entries.push_back({1, 0.5});
            surface.weights.firstEntry.push_back(static_cast<int>(surface.weights.entries.size()));
        }
    }
    return surface;
}

const core::TriangleMesh kBox = test::box({-3, -4, -5}, {3, 4, 5});

TEST(Welded, JoinsTheCornersOfABoxThatWasTakenApart) {
    const WeightedSurface joined = core::welded(exploded(kBox));
    EXPECT_EQ(joined.mesh.vertices.size(), 8U);
    EXPECT_TRUE(test::isClosedAndOriented(joined.mesh));
    EXPECT_NEAR(core::signedVolume(joined.mesh), 480, 0.1);
    ASSERT_EQ(joined.weights.firstEntry.size(), 9U);
    for (int v = 0; v < 8; ++v) {
        const int count = joined.weights.firstEntry[v + 1] - joined.weights.firstEntry[v];
        EXPECT_EQ(count, joined.mesh.vertices[v].z() > 0 ? 2 : 1);
    }
}

TEST(Welded, LeavesVerticesOfOtherWeightsApart) {
    WeightedSurface surface = exploded(kBox);
    surface.weights.entries[0].weight = 1;
    surface.weights.entries[0].bone = 2; // the first corner of the first triangle hangs on another bone
    EXPECT_EQ(core::welded(surface).mesh.vertices.size(), 9U);
}

TEST(Welded, DropsTrianglesWithoutAreaAndUnusedVertices) {
    WeightedSurface surface = exploded(kBox);
    surface.mesh.triangles.push_back({0, 1, 1});
    surface.mesh.vertices.push_back({9, 9, 9});
    surface.weights.entries.push_back({0, 1});
    surface.weights.firstEntry.push_back(static_cast<int>(surface.weights.entries.size()));
    EXPECT_EQ(core::welded(surface).mesh.triangles.size(), 12U);
    EXPECT_EQ(core::welded(surface).mesh.vertices.size(), 8U);
}

TEST(WithHolesClosed, PutsALidOnAnOpenBox) {
    core::TriangleMesh open = kBox;
    open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2); // its bottom
    const WeightedSurface closed = core::withHolesClosed(core::welded(exploded(open)));
    EXPECT_TRUE(test::isClosedAndOriented(closed.mesh));
    EXPECT_EQ(closed.mesh.vertices.size(), 9U);
    EXPECT_NEAR(core::signedVolume(closed.mesh), 480, 0.1);
    EXPECT_NEAR(closed.mesh.vertices.back().z(), -5, 1e-3);
    EXPECT_EQ(closed.weights.firstEntry.size(), 10U);
}

TEST(WithHolesClosed, ChangesNothingThatIsClosed) {
    const WeightedSurface box = core::welded(exploded(kBox));
    EXPECT_EQ(core::withHolesClosed(box).mesh.triangles, box.mesh.triangles);
}

} // namespace
