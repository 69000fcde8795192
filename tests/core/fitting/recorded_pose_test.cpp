// SPDX-License-Identifier: MIT
#include "core/fitting/recorded_pose.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::Pose;
using core::RigidMotion;
using core::Skeleton;

Skeleton makeSkeleton() {
    return test::twoFingerHand(core::Side::Left, core::exp({{100, -50, 400}, {0.3, 1.1, -0.6}})).skeleton;
}

/// What the fit minimises, as its documentation says: origins and ends of the bones and, weakly, rotations.
double objective(const Skeleton& skeleton, const Pose& pose, const std::vector<RigidMotion>& recorded) {
    const std::vector<RigidMotion> bones = core::boneTransforms(skeleton, pose);
    double sum = 0;
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const Eigen::Vector3d end(skeleton.bones[b].lengthMm, 0, 0);
        sum += (bones[b].translation - recorded[b].translation).squaredNorm();
        sum += (bones[b] * end - recorded[b] * end).squaredNorm();
        sum += 25 * core::rotationLog(bones[b].rotation * recorded[b].rotation.transpose()).squaredNorm();
    }
    return sum;
}

TEST(RecordedPose, ComesBackFromItsOwnBones) {
    const Skeleton skeleton = makeSkeleton();
    test::RandomValues random("recorded pose");
    for (int trial = 0; trial < 40; ++trial) {
        const Pose truth = test::somePose(skeleton, random, 300, 3);
        const core::RecordedPoseFit fit = core::fitRecordedPose(skeleton, core::boneTransforms(skeleton, truth));
        ASSERT_EQ(fit.originErrorMm.size(), skeleton.bones.size());
        for (const double error : fit.originErrorMm)
            EXPECT_LT(error, 1e-6);
        EXPECT_LT((fit.pose.head<3>() - truth.head<3>()).norm(), 1e-5);
        EXPECT_LT((core::rotationExp(fit.pose.segment<3>(3)) - core::rotationExp(truth.segment<3>(3))).norm(), 1e-7);
        EXPECT_LT((fit.pose.tail(6) - truth.tail(6)).cwiseAbs().maxCoeff(), 1e-6);
    }
}

TEST(RecordedPose, AnglesOutsideTheirLimitsAreKept) {
    Skeleton skeleton = makeSkeleton();
    Pose truth = skeleton.restPose();
    truth[core::kRigidDofs + 2] = skeleton.dofs[2].maxRad + 0.3;
    const core::RecordedPoseFit fit = core::fitRecordedPose(skeleton, core::boneTransforms(skeleton, truth));
    EXPECT_NEAR(fit.pose[core::kRigidDofs + 2], skeleton.dofs[2].maxRad + 0.3, 1e-6);
}

TEST(RecordedPose, IsTheBestOneWhereTheBonesDoNotFit) {
    const Skeleton skeleton = makeSkeleton();
    test::RandomValues random("noisy bones");
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<RigidMotion> recorded = core::boneTransforms(skeleton, test::somePose(skeleton, random, 300, 3));
        for (RigidMotion& bone : recorded) {
            bone.translation += random.point(1.5);
            bone.rotation = core::rotationExp(random.point(0.05)) * bone.rotation;
        }
        const core::RecordedPoseFit fit = core::fitRecordedPose(skeleton, recorded);
        const double least = objective(skeleton, fit.pose, recorded);
        const auto joints = core::jointPositions(skeleton, fit.pose);
        for (std::size_t b = 0; b < joints.size(); ++b)
            EXPECT_NEAR(fit.originErrorMm[b], (joints[b] - recorded[b].translation).norm(), 1e-9);
        for (Eigen::Index k = 0; k < fit.pose.size(); ++k) {
            for (const double step : {-0.01, 0.01}) {
                const Pose other = core::retract(fit.pose, step * Pose::Unit(fit.pose.size(), k));
                EXPECT_GE(objective(skeleton, other, recorded), least) << k;
            }
        }
    }
}

TEST(RecordedPose, NeedsOnePosePerBone) {
    const Skeleton skeleton = makeSkeleton();
    std::vector<RigidMotion> recorded = core::boneTransforms(skeleton, skeleton.restPose());
    recorded.pop_back();
    try {
        core::fitRecordedPose(skeleton, recorded);
        ADD_FAILURE();
    } catch (const core::Error& error) {
        EXPECT_EQ(error.code(), core::ErrorCode::BadInput);
        EXPECT_EQ(error.field(), "worldFromBone");
    }
}

} // namespace
