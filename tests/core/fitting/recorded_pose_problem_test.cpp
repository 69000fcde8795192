// SPDX-License-Identifier: MIT
#include "core/fitting/recorded_pose_problem.h"

#include "tests/support/problem_checks.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::Pose;
using core::RecordedPoseProblem;
using core::RigidMotion;

/// Bones of a pose, each moved and turned by up to these amounts.
std::vector<RigidMotion> disturbed(std::vector<RigidMotion> bones, test::RandomValues& random, double mm, double rad) {
    for (RigidMotion& bone : bones) {
        bone.translation += random.point(mm);
        bone.rotation = core::rotationExp(random.point(rad)) * bone.rotation;
    }
    return bones;
}

TEST(RecordedPoseProblem, JacobianIsThatOfFiniteDifferencesWhereRotationsFit) {
    const core::Skeleton skeleton = test::twoFingerHand(core::Side::Left, {}).skeleton;
    test::RandomValues random("recorded pose problem");
    for (int trial = 0; trial < 10; ++trial) {
        const Pose pose = test::somePose(skeleton, random, 100, 2);
        const auto recorded = disturbed(core::boneTransforms(skeleton, pose), random, 20, 1e-9);
        const RecordedPoseProblem problem(skeleton, recorded);
        const auto residuals = [&](const Eigen::VectorXd& at) { return problem.residuals(at); };
        const Eigen::MatrixXd exact = problem.jacobian(pose);
        EXPECT_LT((exact - test::numericJacobian(problem, pose, residuals)).norm(), 1e-6 * exact.norm());
        test::expectGradient(problem, pose, 1e-5);
    }
}

TEST(RecordedPoseProblem, JacobianOfTheRotationIsOffByTheOrderOfItsResidual) {
    const core::Skeleton skeleton = test::twoFingerHand(core::Side::Left, {}).skeleton;
    test::RandomValues random("recorded rotations");
    for (const double rad : {0.01, 0.1}) {
        const Pose pose = test::somePose(skeleton, random, 100, 2);
        const auto recorded = disturbed(core::boneTransforms(skeleton, pose), random, 20, rad);
        const RecordedPoseProblem problem(skeleton, recorded);
        const auto residuals = [&](const Eigen::VectorXd& at) { return problem.residuals(at); };
        const Eigen::MatrixXd error = problem.jacobian(pose) - test::numericJacobian(problem, pose, residuals);
        for (Eigen::Index row = 0; row < error.rows(); row += 9) {
            EXPECT_LT(error.middleRows(row, 6).cwiseAbs().maxCoeff(), 1e-5);
            EXPECT_LT(error.middleRows(row + 6, 3).cwiseAbs().maxCoeff(), RecordedPoseProblem::kRotationWeightMm * rad);
        }
    }
}

} // namespace
