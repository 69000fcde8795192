// SPDX-License-Identifier: MIT
#include "core/hand/skeleton.h"

#include <gtest/gtest.h>

#include "tests/support/spatial_twists.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::Pose;
using core::RigidMotion;
using core::Skeleton;
using Eigen::Vector3d;

Skeleton makeSkeleton() {
    return test::twoFingerHand(core::Side::Left, core::exp({{100, -50, 400}, {0.3, 1.1, -0.6}})).skeleton;
}

Eigen::VectorXd stacked(const std::vector<Vector3d>& points) {
    Eigen::VectorXd all(static_cast<Eigen::Index>(3 * points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        all.segment<3>(static_cast<Eigen::Index>(3 * i)) = points[i];
    return all;
}

TEST(Skeleton, RestPoseLeavesTheBonesWhereTheyAre) {
    const Skeleton skeleton = makeSkeleton();
    EXPECT_EQ(skeleton.poseSize(), 12);
    const std::vector<RigidMotion> worldFromBone = core::boneTransforms(skeleton, skeleton.restPose());
    ASSERT_EQ(worldFromBone.size(), skeleton.bones.size());
    for (std::size_t b = 0; b < worldFromBone.size(); ++b) {
        const RigidMotion& rest = skeleton.bones[b].worldFromBoneAtRest;
        EXPECT_LT((worldFromBone[b].rotation - rest.rotation).norm(), 1e-12);
        EXPECT_LT((worldFromBone[b].translation - rest.translation).norm(), 1e-10);
    }
}

TEST(Skeleton, BonesMoveByTheProductOfExponentials) {
    const Skeleton skeleton = makeSkeleton();
    test::RandomValues random("product of exponentials");
    for (int trial = 0; trial < 30; ++trial) {
        const Pose pose = test::somePose(skeleton, random, 100, 3);
        const std::vector<RigidMotion> motions = test::spatialMotions(skeleton, pose);
        const std::vector<RigidMotion> worldFromBone = core::boneTransforms(skeleton, pose);
        for (std::size_t b = 0; b < worldFromBone.size(); ++b) {
            const RigidMotion oracle = motions[b] * skeleton.bones[b].worldFromBoneAtRest;
            EXPECT_LT((worldFromBone[b].rotation - oracle.rotation).norm(), 1e-12) << b;
            EXPECT_LT((worldFromBone[b].translation - oracle.translation).norm(), 1e-9) << b;
        }
    }
}

TEST(Skeleton, DegreesOfFreedomOfOneBoneComposeInTheirOrder) {
    Skeleton skeleton;
    skeleton.bones = {{"wrist", -1, {}, 10}, {"index_mcp", 0, {core::rotationExp({0, 0, 0.5}), {10, 0, 0}}, 30}};
    skeleton.dofs = {{"a", 1, Vector3d::UnitX(), -2, 2}, {"b", 1, Vector3d::UnitZ(), -2, 2}};
    Pose pose = skeleton.restPose();
    pose.tail<2>() << 0.7, -1.1;
    const Eigen::Matrix3d oracle =
        core::rotationExp({0, 0, 0.5}) * core::rotationExp({0.7, 0, 0}) * core::rotationExp({0, 0, -1.1});
    EXPECT_TRUE(core::boneTransforms(skeleton, pose)[1].rotation.isApprox(oracle, 1e-13));
}

TEST(Skeleton, TheWholeHandTurnsAboutItsCentreAndThenMoves) {
    const Skeleton skeleton = makeSkeleton();
    Pose pose = skeleton.restPose();
    pose.head<6>() << 1, 2, 3, 0.4, -2, 0.9;
    const RigidMotion worldFromRest =
        core::boneTransforms(skeleton, pose)[0] * core::inverse(skeleton.bones[0].worldFromBoneAtRest);
    EXPECT_LT((worldFromRest * skeleton.centreAtRest - (skeleton.centreAtRest + Vector3d(1, 2, 3))).norm(), 1e-10);
    EXPECT_TRUE(worldFromRest.rotation.isApprox(core::rotationExp({0.4, -2, 0.9}), 1e-12));
}

TEST(Skeleton, JointsAreTheOriginsOfTheBones) {
    const Skeleton skeleton = makeSkeleton();
    test::RandomValues random("joints");
    const Pose pose = test::somePose(skeleton, random);
    const auto joints = core::jointPositions(skeleton, pose);
    const auto bones = core::boneTransforms(skeleton, pose);
    ASSERT_EQ(joints.size(), bones.size());
    for (std::size_t b = 0; b < joints.size(); ++b)
        EXPECT_EQ(joints[b], bones[b].translation);
    // A bone's child sits at its end, however it bends.
    EXPECT_NEAR((joints[2] - joints[1]).norm(), 42, 1e-9);
}

TEST(Skeleton, RetractAddsTranslationAndAnglesAndTurnsFromTheLeft) {
    const Skeleton skeleton = makeSkeleton();
    test::RandomValues random("retract");
    const Pose pose = test::somePose(skeleton, random, 30, 2.5);
    const Eigen::VectorXd step = random.vector(pose.size(), 0.8);
    const Pose moved = core::retract(pose, step);
    EXPECT_LT((moved.head<3>() - pose.head<3>() - step.head<3>()).norm(), 1e-13);
    EXPECT_LT((moved.tail(6) - pose.tail(6) - step.tail(6)).norm(), 1e-13);
    EXPECT_TRUE(core::rotationExp(moved.segment<3>(3))
                    .isApprox(core::rotationExp(step.segment<3>(3)) * core::rotationExp(pose.segment<3>(3)), 1e-12));
    EXPECT_LT((core::retract(pose, Pose::Zero(pose.size())) - pose).norm(), 1e-12);
}

TEST(Skeleton, JointJacobianIsThatOfFiniteDifferences) {
    const Skeleton skeleton = makeSkeleton();
    test::RandomValues random("joint jacobian");
    for (int trial = 0; trial < 10; ++trial) {
        const Pose pose = test::somePose(skeleton, random, 100, 2.5);
        const Eigen::MatrixXd numeric =
            test::differencesByStep(pose, [&](const Pose& p) { return stacked(core::jointPositions(skeleton, p)); });
        const Eigen::MatrixXd jacobian = core::jointJacobian(skeleton, pose);
        ASSERT_EQ(jacobian.rows(), 15);
        EXPECT_LT((jacobian - numeric).norm(), 1e-6 * numeric.norm());
        EXPECT_LT((jacobian - numeric).cwiseAbs().maxCoeff(), 1e-5);
    }
}

TEST(Skeleton, PointsOnAnAxisStayWhenItTurns) {
    const Skeleton skeleton = makeSkeleton();
    test::RandomValues random("axes");
    const Pose pose = test::somePose(skeleton, random);
    const core::DofAxes axes = core::dofAxes(skeleton, pose);
    const auto before = core::boneTransforms(skeleton, pose);
    ASSERT_EQ(axes.axisInWorld.size(), 12u);
    for (int k = 3; k < 12; ++k) {
        const std::size_t bone =
            k < core::kRigidDofs ? 0 : static_cast<std::size_t>(skeleton.dofs[k - core::kRigidDofs].bone);
        const auto after = core::boneTransforms(skeleton, core::retract(pose, 0.3 * Pose::Unit(12, k)));
        const RigidMotion motion = after[bone] * core::inverse(before[bone]);
        EXPECT_NEAR(axes.axisInWorld[k].norm(), 1, 1e-12);
        for (const double mm : {0.0, 40.0}) {
            // Turns of a bone that come after this one carry the axis along; turned about it alone, it stays.
            const Vector3d point = axes.pointInWorld[k] + mm * axes.axisInWorld[k];
            EXPECT_LT((motion * point - point).norm(), 1e-9) << k;
        }
    }
}

TEST(Skeleton, FindsBonesAndSidesByName) {
    const Skeleton skeleton = makeSkeleton();
    EXPECT_EQ(skeleton.boneIndex("wrist"), 0);
    EXPECT_EQ(skeleton.boneIndex("thumb_ip"), 4);
    EXPECT_EQ(skeleton.boneIndex("nose"), -1);
    for (const core::Side side : {core::Side::Left, core::Side::Right})
        EXPECT_EQ(core::sideFromName(core::sideName(side)), side);
    EXPECT_EQ(core::sideName(core::Side::Left), "left");
    EXPECT_FALSE(core::sideFromName("Left"));
}

} // namespace
