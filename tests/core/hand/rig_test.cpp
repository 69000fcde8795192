// SPDX-License-Identifier: MIT
#include "core/hand/rig.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace {

using Eigen::Vector3d;

core::Rig fingerRig() {
    core::Rig rig;
    rig.joints = {{"wrist", "", {}}, {"index_mcp", "wrist", {}}, {"index_pip", "index_mcp", {}}};
    rig.dofs = {{"index_pip", "flexion", {0, 1, 0}, 0, 90},
                {"index_mcp", "flexion", {0, 2, 0}, -30, 90},
                {"index_mcp", "abduction", {0, 0, 1}, -20, 20}};
    return rig;
}

std::vector<core::RigidMotion> fingerFrames() {
    return {core::anatomicalFrame({0, 0, 0}, {1, 0, 0}, {0, 0, 1}),
            core::anatomicalFrame({90, 0, 0}, {1, 0, 0}, {0, 0, 1}),
            core::anatomicalFrame({130, 0, 0}, {1, 0, 0}, {0, 0, 1})};
}

TEST(AnatomicalFrame, IsARotationWithXForwardAndZTowardsTheBack) {
    const core::RigidMotion frame = core::anatomicalFrame({1, 2, 3}, {0, 5, 0}, {0.3, 1, 2});
    EXPECT_TRUE(core::isRotation(frame.rotation, 1e-12));
    EXPECT_TRUE(frame.rotation.col(0).isApprox(Vector3d::UnitY(), 1e-12));
    EXPECT_GT(frame.rotation.col(2).z(), 0.9);
    EXPECT_TRUE(frame.translation.isApprox(Vector3d(1, 2, 3)));
}

TEST(RiggedSkeleton, HasBonesLengthsAndDofsGroupedByBone) {
    const core::Skeleton skeleton = core::riggedSkeleton(fingerRig(), core::Side::Right, fingerFrames());
    ASSERT_EQ(skeleton.bones.size(), 3U);
    EXPECT_EQ(skeleton.bones[2].parent, 1);
    EXPECT_DOUBLE_EQ(skeleton.bones[0].lengthMm, 90);
    EXPECT_DOUBLE_EQ(skeleton.bones[1].lengthMm, 40);
    EXPECT_DOUBLE_EQ(skeleton.bones[2].lengthMm, 0);
    ASSERT_EQ(skeleton.dofs.size(), 3U);
    EXPECT_EQ(skeleton.dofs[0].name, "index_mcp.flexion");
    EXPECT_EQ(skeleton.dofs[1].name, "index_mcp.abduction");
    EXPECT_EQ(skeleton.dofs[2].bone, 2);
    EXPECT_NEAR(skeleton.dofs[0].maxRad, std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(skeleton.dofs[0].axisInBone.norm(), 1, 1e-12);
}

TEST(RiggedSkeleton, PositiveFlexionBendsTowardsThePalm) {
    const core::Skeleton skeleton = core::riggedSkeleton(fingerRig(), core::Side::Right, fingerFrames());
    core::Pose pose = skeleton.restPose();
    pose[core::kRigidDofs] = std::numbers::pi / 2;
    EXPECT_LT(core::jointPositions(skeleton, pose)[2].z(), -39);
}

TEST(RiggedSkeleton, TheSameAngleMirrorsTheMovementOnTheLeft) {
    const core::Skeleton right = core::riggedSkeleton(fingerRig(), core::Side::Right, fingerFrames());
    const core::Skeleton left = core::riggedSkeleton(fingerRig(), core::Side::Left, fingerFrames());
    core::Pose pose = right.restPose();
    pose[core::kRigidDofs] = 0.4;
    pose[core::kRigidDofs + 1] = 0.3;
    const Vector3d r = core::jointPositions(right, pose)[2], l = core::jointPositions(left, pose)[2];
    EXPECT_GT(r.y(), 5); // towards the thumb
    EXPECT_NEAR(l.x(), r.x(), 1e-9);
    EXPECT_NEAR(l.y(), -r.y(), 1e-9);
    EXPECT_NEAR(l.z(), r.z(), 1e-9);
}

} // namespace
