// SPDX-License-Identifier: MIT
#include "core/hand/hand_model.h"

#include <gtest/gtest.h>

#include "tests/support/spatial_twists.h"
#include "tests/support/two_finger_hand.h"

namespace {

using core::HandModel;
using core::Pose;
using core::SkinWeights;
using Eigen::Vector3d;

HandModel makeHand() {
    return test::twoFingerHand(core::Side::Right, core::exp({{40, 90, -200}, {-0.8, 0.4, 2}}));
}

TEST(HandModel, RestPoseLeavesTheSurfaceWhereItIs) {
    const HandModel hand = makeHand();
    const std::vector<Vector3d> posed = core::posedVertices(hand, hand.skeleton.restPose());
    for (std::size_t v = 0; v < posed.size(); ++v)
        EXPECT_LT((posed[v] - hand.mesh.vertices[v]).norm(), 1e-9);
}

TEST(HandModel, VerticesAreBlendedProductsOfExponentials) {
    const HandModel hand = makeHand();
    test::RandomValues random("skinning");
    for (int trial = 0; trial < 5; ++trial) {
        const Pose pose = test::somePose(hand.skeleton, random, 100, 2.5);
        const std::vector<Vector3d> oracle = test::spatiallyPosed(hand, pose);
        const std::vector<Vector3d> posed = core::posedVertices(hand, pose);
        ASSERT_EQ(posed.size(), oracle.size());
        for (std::size_t v = 0; v < posed.size(); ++v)
            ASSERT_LT((posed[v] - oracle[v]).norm(), 1e-9) << v;
    }
}

TEST(HandModel, VertexJacobianIsThatOfFiniteDifferences) {
    const HandModel hand = makeHand();
    test::RandomValues random("vertex jacobian");
    for (int trial = 0; trial < 4; ++trial) {
        const Pose pose = test::somePose(hand.skeleton, random, 100, 2.5);
        std::vector<int> vertices;
        for (int i = 0; i < 25; ++i)
            vertices.push_back(random.below(static_cast<int>(hand.mesh.vertices.size())));
        const Eigen::MatrixXd numeric = test::differencesByStep(pose, [&](const Pose& p) {
            const std::vector<Vector3d> posed = core::posedVertices(hand, p);
            Eigen::VectorXd chosen(3 * vertices.size());
            for (std::size_t i = 0; i < vertices.size(); ++i)
                chosen.segment<3>(static_cast<Eigen::Index>(3 * i)) = posed[static_cast<std::size_t>(vertices[i])];
            return chosen;
        });
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Eigen::MatrixXd expected = numeric.middleRows(static_cast<Eigen::Index>(3 * i), 3);
            EXPECT_LT((core::vertexJacobian(hand, pose, vertices[i]) - expected).norm(), 1e-6 * expected.norm());
        }
    }
}

TEST(HandModel, CompressedWeightsKeepTheLargestAndSumToOne) {
    SkinWeights weights;
    weights.firstEntry = {0, 4, 5, 8};
    weights.entries = {{0, 0.1}, {1, 0.6}, {2, 0.0004}, {3, 0.2996}, {4, 1.0}, {5, 0.0002}, {6, 0.0003}, {7, 0.0001}};
    const SkinWeights result = core::compressedWeights(weights, 2, 1e-3);
    ASSERT_EQ(result.firstEntry, (std::vector<int>{0, 2, 3, 4}));
    EXPECT_EQ(result.entries[0].bone, 1);
    EXPECT_EQ(result.entries[1].bone, 3);
    EXPECT_NEAR(result.entries[0].weight, 0.6 / 0.8996, 1e-12);
    EXPECT_NEAR(result.entries[0].weight + result.entries[1].weight, 1, 1e-12);
    EXPECT_EQ(result.entries[3].bone, 6) << "where all are small the largest stays";
    EXPECT_DOUBLE_EQ(result.entries[3].weight, 1);
}

TEST(HandModel, CompressedWeightsLeaveShortRowsAlone) {
    const HandModel hand = makeHand();
    const SkinWeights same = core::compressedWeights(hand.weights, 8, 0);
    ASSERT_EQ(same.firstEntry, hand.weights.firstEntry);
    double sum = 0;
    for (const core::SkinWeight& w : same.entries)
        sum += w.weight;
    EXPECT_NEAR(sum, static_cast<double>(hand.mesh.vertices.size()), 1e-8);
}

TEST(HandModel, MeanJointDistanceIsOverAllJointsOfAllHands) {
    const std::vector<HandModel> hands = test::twoFingerHands();
    core::HandPoses a{hands[0].skeleton.restPose(), hands[1].skeleton.restPose()}, b = a;
    b[1].head<3>() = Vector3d(3, 4, 0); // five joints of ten move by 5 mm
    EXPECT_NEAR(core::meanJointDistanceMm(hands, a, b), 2.5, 1e-9);
    EXPECT_NEAR(core::meanJointDistanceMm(hands, b, a), 2.5, 1e-9);
    EXPECT_EQ(core::meanJointDistanceMm(hands, a, a), 0);
    EXPECT_EQ(core::meanJointDistanceMm({}, {}, {}), 0);
}

} // namespace
