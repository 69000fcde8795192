// SPDX-License-Identifier: MIT
#include "core/hand/finger_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "tests/support/random_values.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::BoneCapsule;
using core::CapsuleOverlap;
using core::CapsulePair;
using core::Pose;

class FingerOverlap : public testing::Test {
protected:
    const core::Skeleton& skeleton() const { return m_hands.front().skeleton; }
    std::vector<CapsuleOverlap> at(const Pose& pose) const {
        return core::capsuleOverlaps(m_capsules, m_hands, {pose});
    }

    /// Somewhere in space, with the thumb turned and bent over the index finger by more or less.
    Pose crossing(test::RandomValues& random) const {
        Pose pose = test::somePose(skeleton(), random);
        for (std::size_t d = 0; d < skeleton().dofs.size(); ++d) {
            double& angle = pose[core::kRigidDofs + static_cast<Eigen::Index>(d)];
            if (skeleton().dofs[d].name == "thumb_mcp.abduction")
                angle -= random.between(0.5, 1.5);
        }
        return pose;
    }

    const std::vector<core::HandModel> m_hands{test::twoFingerHand(core::Side::Right)};
    const core::HandCapsules m_capsules = core::handCapsules(m_hands);
};

/// The depth by looking at many points of both segments: an upper bound of the distance, 0.01 mm off at most.
double sampledDepthMm(const core::HandCapsules& hand, const CapsulePair& pair, const core::Skeleton& skeleton,
                      const Pose& pose) {
    constexpr int kSteps = 800;
    const std::vector<core::RigidMotion> worldFromBone = core::boneTransforms(skeleton, pose);
    const auto posed = [&](const BoneCapsule& capsule, double share) -> Eigen::Vector3d {
        const auto b = static_cast<std::size_t>(capsule.bone);
        const Eigen::Vector3d atRest = (1 - share) * capsule.startAtRest + share * capsule.endAtRest;
        return worldFromBone[b] * (core::inverse(skeleton.bones[b].worldFromBoneAtRest) * atRest);
    };
    const BoneCapsule& a = hand.capsules.front()[static_cast<std::size_t>(pair.a)];
    const BoneCapsule& b = hand.capsules.front()[static_cast<std::size_t>(pair.b)];
    std::vector<Eigen::Vector3d> ofA, ofB;
    for (int i = 0; i <= kSteps; ++i) {
        ofA.push_back(posed(a, static_cast<double>(i) / kSteps));
        ofB.push_back(posed(b, static_cast<double>(i) / kSteps));
    }
    double least2 = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : ofA)
        for (const Eigen::Vector3d& q : ofB)
            least2 = std::min(least2, (p - q).squaredNorm());
    return a.radiusMm + b.radiusMm - pair.allowedMm - std::sqrt(least2);
}

TEST_F(FingerOverlap, CapsulesHaveTheWidthAndLengthOfTheSkin) {
    ASSERT_EQ(m_capsules.capsules.front().size(), 4u);
    const double radiusMm[] = {9, 9, 10, 10}, lengthMm[] = {42, 32, 36, 30}; // as the hand was built
    for (std::size_t c = 0; c < 4; ++c) {
        const BoneCapsule& capsule = m_capsules.capsules.front()[c];
        EXPECT_NEAR(capsule.radiusMm, radiusMm[c], 0.6) << skeleton().bones[capsule.bone].name;
        EXPECT_NEAR((capsule.endAtRest - capsule.startAtRest).norm(), lengthMm[c], 3);
        EXPECT_EQ(capsule.finger, c < 2 ? 1 : 3);
    }
    EXPECT_EQ(m_capsules.pairs.size(), 4u) << "each bone of one finger with each of the other";
}

TEST_F(FingerOverlap, TheRestPoseHasNone) {
    EXPECT_TRUE(at(skeleton().restPose()).empty());
}

TEST_F(FingerOverlap, TheDepthIsThatOfManyPoints) {
    test::RandomValues random("finger overlap depth");
    int overlapping = 0, apart = 0;
    for (int trial = 0; trial < 12; ++trial) {
        const Pose pose = crossing(random);
        const std::vector<CapsuleOverlap> found = at(pose);
        for (const CapsulePair& pair : m_capsules.pairs) {
            const double depthMm = sampledDepthMm(m_capsules, pair, skeleton(), pose);
            const auto overlap = std::find_if(found.begin(), found.end(), [&](const CapsuleOverlap& o) {
                return o.boneA == m_capsules.capsules.front()[pair.a].bone &&
                       o.boneB == m_capsules.capsules.front()[pair.b].bone;
            });
            if (overlap == found.end()) {
                EXPECT_LT(depthMm, 0.01);
                ++apart;
                continue;
            }
            EXPECT_NEAR(overlap->depthMm, depthMm, 0.02);
            EXPECT_NEAR(overlap->apart.norm(), 1, 1e-9);
            ++overlapping;
        }
    }
    EXPECT_GT(overlapping, 5);
    EXPECT_GT(apart, 5);
}

TEST_F(FingerOverlap, TheJacobianIsTheChangeOfTheDepth) {
    constexpr double kStep = 1e-6;
    test::RandomValues random("finger overlap jacobian");
    int looked = 0;
    for (int trial = 0; trial < 12; ++trial) {
        const Pose pose = crossing(random);
        const std::vector<CapsuleOverlap> found = at(pose);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (found[i].depthMm < 0.1)
                continue;
            const Eigen::RowVectorXd row =
                core::overlapJacobian(found[i], 0, skeleton(), core::dofAxes(skeleton(), pose));
            for (Eigen::Index k = 0; k < row.size(); ++k) {
                const auto depthMm = [&](double by) {
                    const Eigen::VectorXd step = by * Eigen::VectorXd::Unit(row.size(), k);
                    for (const CapsuleOverlap& o : at(core::retract(pose, step)))
                        if (o.boneA == found[i].boneA && o.boneB == found[i].boneB)
                            return o.depthMm;
                    return 0.0;
                };
                EXPECT_NEAR(row[k], (depthMm(kStep) - depthMm(-kStep)) / (2 * kStep), 1e-3) << "freedom " << k;
            }
            ++looked;
        }
    }
    EXPECT_GT(looked, 5);
}

TEST_F(FingerOverlap, StepsTakeFingersApart) {
    test::RandomValues random("finger overlap steps");
    const auto sum = [&](const Pose& pose) {
        double all = 0;
        for (const CapsuleOverlap& overlap : at(pose))
            all += overlap.depthMm * overlap.depthMm;
        return all;
    };
    int began = 0;
    for (int trial = 0; trial < 12; ++trial) {
        Pose pose = crossing(random);
        const double before = sum(pose);
        began += before > 4;
        for (int i = 0; i < 8; ++i) {
            Eigen::MatrixXd hessian = 20 * Eigen::MatrixXd::Identity(pose.size(), pose.size());
            Eigen::VectorXd gradient = Eigen::VectorXd::Zero(pose.size());
            core::addOverlaps(at(pose), 0, skeleton(), pose, 10, hessian, gradient);
            pose = core::retract(pose, hessian.llt().solve(-gradient));
        }
        EXPECT_LT(sum(pose), 0.05 * before + 1e-3);
    }
    EXPECT_GT(began, 3);
}

TEST_F(FingerOverlap, HandsPushEachOtherApart) {
    const std::vector<core::HandModel> hands{m_hands.front(), m_hands.front()};
    const core::HandCapsules capsules = core::handCapsules(hands);
    EXPECT_EQ(capsules.pairs.size(), 4u + 4u + 16u);
    core::HandPoses poses{skeleton().restPose(), skeleton().restPose()};
    poses[1][2] += 12; // beside the other, closer than fingers are thick
    const std::vector<CapsuleOverlap> found = core::capsuleOverlaps(capsules, hands, poses);
    ASSERT_FALSE(found.empty());
    for (const CapsuleOverlap& overlap : found) {
        EXPECT_EQ(overlap.handA, 0);
        EXPECT_EQ(overlap.handB, 1);
    }
    for (int hand : {0, 1}) {
        Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(6, 6);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(6);
        core::addOverlaps(found, hand, skeleton(), poses[static_cast<std::size_t>(hand)], 1, hessian, gradient);
        EXPECT_GT(hand == 0 ? gradient[2] : -gradient[2], 1) << "down the gradient is away from the other";
    }
}

TEST_F(FingerOverlap, ASmallerSystemMovesItsDegreesOfFreedomAlone) {
    test::RandomValues random("finger overlap rigid");
    const Pose pose = crossing(random);
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(pose.size(), pose.size()), rigid = Eigen::MatrixXd::Zero(6, 6);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(pose.size()), rigidGradient = Eigen::VectorXd::Zero(6);
    core::addOverlaps(at(pose), 0, skeleton(), pose, 2, all, gradient);
    core::addOverlaps(at(pose), 0, skeleton(), pose, 2, rigid, rigidGradient);
    EXPECT_NEAR((all.topLeftCorner(6, 6) - rigid).norm(), 0, 1e-9);
    EXPECT_NEAR(rigidGradient.norm(), 0, 1e-6) << "moving the whole hand takes no finger out of another";
}

} // namespace
