// SPDX-License-Identifier: MIT
#include "core/geometry/camera_target.h"

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"

namespace {

using Eigen::Vector3d;

/// The ring, whose axes meet in the origin, carried elsewhere.
std::vector<core::Camera> ringAround(const Vector3d& centre) {
    std::vector<core::Camera> ring = test::cameraRing(4);
    for (core::Camera& camera : ring)
        camera.cameraFromWorld.translation -= camera.cameraFromWorld.rotation * centre;
    return ring;
}

TEST(CommonTarget, IsWhereTheAxesMeet) {
    const Vector3d centre(120, -40, 700);
    const auto target = core::commonTarget(ringAround(centre));
    ASSERT_TRUE(target);
    EXPECT_LT((*target - centre).norm(), 1e-6);
    EXPECT_LT((core::commonTargetNearOrigin(ringAround(centre)) - centre).norm(), 0.01);
}

TEST(CommonTarget, IsOpenForOneCameraAndForParallelAxes) {
    const std::vector<core::Camera> ring = test::cameraRing(4);
    EXPECT_FALSE(core::commonTarget({}));
    EXPECT_FALSE(core::commonTarget({ring[0]}));
    EXPECT_FALSE(core::commonTarget({ring[0], ring[0]}));
}

TEST(CommonTarget, NearOriginIsTheFootOnTheAxisOfASingleCamera) {
    core::Camera camera = test::cameraRing(4)[0];
    camera.cameraFromWorld.translation += Vector3d(30, 0, 0); // the axis passes 30 mm beside the origin
    const Vector3d target = core::commonTargetNearOrigin({camera});
    const Vector3d axis = camera.cameraFromWorld.rotation.row(2);
    EXPECT_NEAR(target.norm(), 30, 0.01);
    EXPECT_NEAR(target.dot(axis), 0, 0.01);
    EXPECT_LT((camera.cameraFromWorld * target).head<2>().norm(), 0.01);
}

} // namespace
