// SPDX-License-Identifier: MIT
#include "core/demo_hand/choreography.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/demo_hand/contact.h"
#include "core/demo_hand/implicit_surface.h"

namespace {

using Eigen::Vector3d;

/// A hand that is a ball of 10 mm around its wrist, with a second bone that turns about y.
core::HandModel ballHand(core::Side side) {
    core::HandModel hand;
    hand.side = side;
    hand.mesh = core::polygonise([](const Vector3d& p) { return p.norm() - 10; },
                                 {Vector3d::Constant(-12), Vector3d::Constant(12)}, 0.8, Vector3d::Zero());
    hand.skeleton.bones = {{"wrist", -1, {}, 20}, {"index_mcp", 0, {Eigen::Matrix3d::Identity(), {20, 0, 0}}, 0}};
    hand.skeleton.dofs = {{"index_mcp.flexion", 1, Vector3d::UnitY(), -0.5, 1.5}};
    hand.skeleton.centreAtRest = {7, 1, 0};
    hand.weights.firstEntry.push_back(0);
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v) {
        hand.weights.entries.push_back({0, 1.0});
        hand.weights.firstEntry.push_back(static_cast<int>(v) + 1);
    }
    return hand;
}

const std::vector<core::HandModel>& playedHands() {
    static const std::vector<core::HandModel> kHands{ballHand(core::Side::Left), ballHand(core::Side::Right)};
    return kHands;
}

core::HandKey key(double frame, const Vector3d& wrist, double turnRad, double angleRad) {
    return {frame, wrist, Eigen::Quaterniond(Eigen::AngleAxisd(turnRad, Vector3d::UnitZ())),
            Eigen::VectorXd::Constant(1, angleRad)};
}

core::Choreography twoKeys() {
    core::Choreography choreography;
    choreography.frameCount = 21;
    choreography.keys = {{key(0, {-40, 0, 0}, 0, 0), key(20, {-20, 0, 0}, 1, 1)},
                         {key(0, {40, 0, 0}, 0, 0.2), key(20, {20, 5, 0}, -2, 0.4)}};
    return choreography;
}

TEST(Play, PutsTheWristWhereTheKeysSay) {
    const core::Motion motion = core::play(twoKeys(), playedHands());
    ASSERT_EQ(motion.size(), 21U);
    const auto wrist = [&](int frame, int hand) {
        return core::boneTransforms(playedHands()[hand].skeleton, motion[frame][hand])[0];
    };
    EXPECT_TRUE(wrist(0, 0).translation.isApprox(Vector3d(-40, 0, 0), 1e-9));
    EXPECT_TRUE(wrist(20, 1).translation.isApprox(Vector3d(20, 5, 0), 1e-9));
    EXPECT_TRUE(wrist(20, 0).rotation.isApprox(core::rotationExp({0, 0, 1}), 1e-9));
    EXPECT_NEAR(motion[20][0][core::kRigidDofs], 1, 1e-12);
    EXPECT_GT(motion[10][0][core::kRigidDofs], 0.2);
    EXPECT_LT(motion[10][0][core::kRigidDofs], 0.8);
}

TEST(Play, TheStageCarriesBothHands) {
    core::Choreography choreography = twoKeys();
    choreography.stage = {{0, {1, 2, 3}, {0, 0, 0}}, {20, {0, 0, 100}, {0, std::acos(-1.0) / 2, 0}}};
    const core::Motion motion = core::play(choreography, playedHands());
    const Vector3d first = core::jointPositions(playedHands()[0].skeleton, motion[0][0])[0];
    const Vector3d last = core::jointPositions(playedHands()[1].skeleton, motion[20][1])[0];
    EXPECT_TRUE(first.isApprox(Vector3d(-39, 2, 3), 1e-9));
    EXPECT_TRUE(last.isApprox(Vector3d(0, 5, 80), 1e-9)); // x turns to -z
}

TEST(Play, ContactKeepsTheGapAndNeverLessOnTheWay) {
    core::Choreography choreography = twoKeys();
    choreography.contact = core::ContactRule{Vector3d::UnitX(), 0.25, 2, {{0, 30}, {20, 0}}};
    const core::Motion free = core::play(twoKeys(), playedHands());
    const core::Motion motion = core::play(choreography, playedHands());
    const auto gap = [&](int frame) {
        return core::gapAlong(Vector3d::UnitX(), core::posedVertices(playedHands()[0], motion[frame][0]),
                              playedHands()[0].mesh.triangles, core::posedVertices(playedHands()[1], motion[frame][1]),
                              playedHands()[1].mesh.triangles);
    };
    EXPECT_GE(gap(20), -0.01);
    EXPECT_LT(gap(20), 6);
    EXPECT_GE(gap(0), 29.9);
    for (int frame = 0; frame < 21; ++frame) {
        EXPECT_GE(gap(frame), -0.3);
        const double movedFirst = (motion[frame][0] - free[frame][0]).norm();
        const double movedSecond = (motion[frame][1] - free[frame][1]).norm();
        EXPECT_NEAR(movedFirst, 3 * movedSecond, 1e-9);
    }
}

} // namespace
