// SPDX-License-Identifier: MIT
#include "core/hand/finger_prior.h"

#include <algorithm>
#include <string>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/io/demo/demo_hands.h"

namespace {

/// Number of the degree of freedom of that name.
Eigen::Index dofOf(const core::Skeleton& skeleton, const std::string& name) {
    const auto found = std::find_if(skeleton.dofs.begin(), skeleton.dofs.end(),
                                    [&](const core::DegreeOfFreedom& dof) { return dof.name == name; });
    return found - skeleton.dofs.begin();
}

/// Second moments of the changes of all angles within 1, 5, 10 and 15 frames of the demo's choreographies.
Eigen::MatrixXd momentsOfTheDemo(const core::Skeleton& skeleton) {
    const std::vector<core::HandModel>& hands = core::demoHands();
    const auto size = static_cast<Eigen::Index>(skeleton.dofs.size());
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
    double count = 0;
    for (const core::Choreography& choreography : core::demoChoreographies(hands)) {
        const core::Motion motion = core::play(choreography, hands);
        for (const std::size_t difference : {1u, 5u, 10u, 15u}) {
            for (std::size_t f = difference; f < motion.size(); ++f) {
                for (std::size_t h = 0; h < motion[f].size(); ++h) {
                    const Eigen::VectorXd change = (motion[f][h] - motion[f - difference][h]).tail(size);
                    sum += change * change.transpose();
                    ++count;
                }
            }
        }
    }
    return sum / count;
}

const std::string kFingers[] = {"index", "middle", "ring", "little"};
const std::string kJoints[] = {"mcp", "pip", "dip"};

TEST(FingerPrior, HoldsWhatTheDemosChoreographiesDo) {
    const core::Skeleton skeleton = core::demoHands().front().skeleton;
    const Eigen::MatrixXd moments = momentsOfTheDemo(skeleton);
    const auto moment = [&](int f, int j, int g, int k) {
        return moments(dofOf(skeleton, kFingers[f] + "_" + kJoints[j] + ".flexion"),
                       dofOf(skeleton, kFingers[g] + "_" + kJoints[k] + ".flexion"));
    };
    const core::FingerMotion& learnt = core::learntFingerMotion();
    Eigen::Matrix3d joints = Eigen::Matrix3d::Zero();
    Eigen::Vector4d between = Eigen::Vector4d::Zero(), scale = Eigen::Vector4d::Zero();
    for (int f = 0; f < 4; ++f) {
        for (int j = 0; j < 3; ++j) {
            for (int k = 0; k < 3; ++k)
                joints(j, k) += moment(f, j, f, k) / 4;
            for (int g = 0; g < 4; ++g) {
                between[std::abs(f - g)] += moment(f, j, g, j);
                scale[std::abs(f - g)] += std::sqrt(moment(f, j, f, j) * moment(g, j, g, j));
            }
        }
    }
    for (int j = 0; j < 3; ++j) {
        EXPECT_NEAR(learnt.jointRad[j], std::sqrt(joints(j, j)), 6e-4) << kJoints[j];
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(learnt.jointCorrelation(j, k), joints(j, k) / std::sqrt(joints(j, j) * joints(k, k)), 6e-3);
    }
    for (int d = 0; d < 4; ++d)
        EXPECT_NEAR(learnt.fingerCorrelation[d], between[d] / scale[d], 6e-3) << d << " fingers apart";
}

TEST(FingerPrior, AHiddenJointFollowsTheOthersOfItsFinger) {
    const core::Skeleton skeleton = core::demoHands().front().skeleton;
    const Eigen::MatrixXd precision = core::fingerChangePrecision(skeleton, core::learntFingerMotion());
    ASSERT_GT(precision.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
    const Eigen::Index mcp = dofOf(skeleton, "ring_mcp.flexion"), pip = dofOf(skeleton, "ring_pip.flexion");
    const Eigen::Index dip = dofOf(skeleton, "ring_dip.flexion");
    // The mean of dip given the two others: -P_dd^-1 P_do x_o over what is left when all others are integrated out.
    const Eigen::MatrixXd covariance = precision.inverse();
    Eigen::Matrix2d seen;
    seen << covariance(mcp, mcp), covariance(mcp, pip), covariance(pip, mcp), covariance(pip, pip);
    const Eigen::Vector2d with(covariance(dip, mcp), covariance(dip, pip));
    const double expected = with.dot(seen.inverse() * Eigen::Vector2d(0.6, 0.9));
    EXPECT_GT(expected, 0.35);
    EXPECT_LT(expected, 0.6);
}

TEST(FingerPrior, BendsCountTowardsThePalmWhateverTheSignOfTheAngle) {
    core::Skeleton skeleton = core::demoHands().front().skeleton;
    const Eigen::MatrixXd before = core::fingerChangePrecision(skeleton, core::learntFingerMotion());
    const Eigen::Index pip = dofOf(skeleton, "index_pip.flexion"), dip = dofOf(skeleton, "index_dip.flexion");
    core::DegreeOfFreedom& dof = skeleton.dofs[static_cast<std::size_t>(pip)];
    std::swap(dof.minRad, dof.maxRad);
    dof.minRad *= -1;
    dof.maxRad *= -1;
    const Eigen::MatrixXd after = core::fingerChangePrecision(skeleton, core::learntFingerMotion());
    EXPECT_NEAR(after(pip, dip), -before(pip, dip), 1e-9 * std::abs(before(pip, dip)));
    EXPECT_NEAR(after(pip, pip), before(pip, pip), 1e-9 * before(pip, pip));
}

TEST(FingerPrior, OtherAnglesChangeOnTheirOwnByATenthOfTheirRange) {
    const core::Skeleton skeleton = core::demoHands().front().skeleton;
    const Eigen::MatrixXd precision = core::fingerChangePrecision(skeleton, core::learntFingerMotion());
    const Eigen::Index twist = dofOf(skeleton, "ring_mcp.twist");
    const core::DegreeOfFreedom& dof = skeleton.dofs[static_cast<std::size_t>(twist)];
    EXPECT_NEAR(1 / std::sqrt(precision(twist, twist)), 0.1 * (dof.maxRad - dof.minRad), 1e-9);
    EXPECT_NEAR(precision.row(twist).cwiseAbs().sum(), precision(twist, twist), 1e-9);
}

TEST(FingerPrior, DerivativesAreThoseOfTheCost) {
    const core::Skeleton skeleton = core::demoHands().front().skeleton;
    const Eigen::MatrixXd precision = core::fingerChangePrecision(skeleton, core::learntFingerMotion());
    const Eigen::Index size = precision.rows();
    constexpr double kWeight = 0.7, kStep = 1e-4;
    const Eigen::VectorXd change = 0.3 * Eigen::VectorXd::LinSpaced(size, -1, 1.4).array().sin().matrix();
    const auto cost = [&](Eigen::Index k, double a, Eigen::Index l, double b) {
        Eigen::VectorXd moved = change;
        moved[k] += a;
        moved[l] += b;
        return core::fingerChangeCost(precision, kWeight, moved);
    };
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(core::kRigidDofs + size, core::kRigidDofs + size);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(core::kRigidDofs + size);
    core::addFingerChange(precision, kWeight, change, hessian, gradient);
    EXPECT_EQ(gradient.head<core::kRigidDofs>().norm(), 0) << "where the hand is costs nothing";
    EXPECT_EQ(hessian.topRows<core::kRigidDofs>().norm(), 0);
    const double steep = gradient.cwiseAbs().maxCoeff(), curved = hessian.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < size; ++k) {
        EXPECT_NEAR(gradient[core::kRigidDofs + k], (cost(k, kStep, 0, 0) - cost(k, -kStep, 0, 0)) / (2 * kStep),
                    1e-6 * steep);
        for (Eigen::Index l = 0; l < size; ++l) {
            const double mixed = (cost(k, kStep, l, kStep) - cost(k, kStep, l, -kStep) - cost(k, -kStep, l, kStep) +
                                  cost(k, -kStep, l, -kStep)) /
                                 (4 * kStep * kStep);
            EXPECT_NEAR(hessian(core::kRigidDofs + k, core::kRigidDofs + l), mixed, 1e-5 * curved);
        }
    }
    // The residual: the cost is half the square of sqrt(weight) L^T change with precision = L L^T.
    const Eigen::MatrixXd root = precision.llt().matrixL();
    const Eigen::VectorXd residual = std::sqrt(kWeight) * root.transpose() * change;
    EXPECT_NEAR(core::fingerChangeCost(precision, kWeight, change), 0.5 * residual.squaredNorm(), 1e-9);
}

} // namespace
