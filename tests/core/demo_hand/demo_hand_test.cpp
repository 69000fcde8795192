// SPDX-License-Identifier: MIT
#include "core/demo_hand/demo_hand.h"

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/io/demo/demo_hands.h"
#include "tests/support/shapes/mesh_checks.h"

namespace {

using core::HandModel;
using core::Pose;
using Eigen::Vector3d;

const std::vector<HandModel>& hands() {
    static const std::vector<HandModel>& kHands = core::demoHands();
    return kHands;
}
const HandModel& leftHand() {
    return hands()[0];
}
const HandModel& rightHand() {
    return hands()[1];
}

Pose bent(const HandModel& hand, const std::map<std::string, double>& anglesDeg) {
    Pose pose = hand.skeleton.restPose();
    for (std::size_t d = 0; d < hand.skeleton.dofs.size(); ++d) {
        const auto angle = anglesDeg.find(hand.skeleton.dofs[d].name);
        if (angle != anglesDeg.end())
            pose[core::kRigidDofs + static_cast<Eigen::Index>(d)] = angle->second * std::numbers::pi / 180;
    }
    return pose;
}

double weightOn(const HandModel& hand, int vertex, const std::string& bonePrefix) {
    double sum = 0;
    for (int e = hand.weights.firstEntry[vertex]; e < hand.weights.firstEntry[vertex + 1]; ++e) {
        const core::SkinWeight& w = hand.weights.entries[e];
        sum += hand.skeleton.bones[w.bone].name.rfind(bonePrefix, 0) == 0 ? w.weight : 0;
    }
    return sum;
}

/// Area of the cut through a finger at a joint, by the plane through it with that normal.
double cutArea(const HandModel& hand, const Pose& pose, const std::string& finger, const Vector3d& centre,
               const Vector3d& normal) {
    const std::vector<Vector3d> posed = core::posedVertices(hand, pose);
    double area = 0;
    for (const auto& t : hand.mesh.triangles) {
        std::vector<Vector3d> crossings;
        bool isNear = true;
        for (int k = 0; k < 3; ++k) {
            const Vector3d &a = posed[t[k]], &b = posed[t[(k + 1) % 3]];
            isNear = isNear && weightOn(hand, t[k], finger) > 0.9 && (a - centre).norm() < 25;
            const double da = (a - centre).dot(normal), db = (b - centre).dot(normal);
            if ((da < 0) != (db < 0)) {
                crossings.push_back(a + da / (da - db) * (b - a));
                if (da < 0 && crossings.size() == 2)
                    std::swap(crossings[0], crossings[1]); // from below to above first
            }
        }
        if (isNear && crossings.size() == 2)
            area += 0.5 * normal.dot((crossings[0] - centre).cross(crossings[1] - centre));
    }
    return std::abs(area);
}

TEST(DemoHand, IsClosedOrientedAndOfAHandsSize) {
    for (const HandModel& hand : hands()) {
        EXPECT_TRUE(test::isClosedAndOriented(hand.mesh));
        EXPECT_EQ(test::eulerNumber(hand.mesh), 2);
        EXPECT_GE(hand.mesh.vertices.size(), 2000U);
        EXPECT_LE(hand.mesh.vertices.size(), 6000U);
        // A man's hand displaces about 0.35 to 0.4 litres, a stub of the forearm included.
        EXPECT_GT(core::signedVolume(hand.mesh), 280e3);
        EXPECT_LT(core::signedVolume(hand.mesh), 450e3);
        double reach = 0;
        for (const Vector3d& vertex : hand.mesh.vertices)
            reach = std::max(reach, vertex.x());
        EXPECT_NEAR(reach, 190, 6);
    }
}

TEST(DemoHand, HasStandardJointsAnd35DegreesOfFreedom) {
    for (const HandModel& hand : hands()) {
        EXPECT_EQ(hand.skeleton.poseSize(), 35);
        EXPECT_EQ(hand.skeleton.bones.size(), 25U);
        for (const char* name : {"wrist", "thumb_cmc", "thumb_mcp", "thumb_ip", "thumb_tip", "index_cmc", "middle_mcp",
                                 "ring_pip", "little_dip", "little_tip"})
            EXPECT_GE(hand.skeleton.boneIndex(name), 0) << name;
        for (const core::DegreeOfFreedom& dof : hand.skeleton.dofs) {
            EXPECT_LE(dof.minRad, 0) << dof.name;
            EXPECT_GE(dof.maxRad, 0) << dof.name;
        }
    }
}

TEST(DemoHand, HasTheProportionsOfHumanBones) {
    // Mean lengths of adults' bones (Buryanov and Kotiuk 2010), mm.
    const std::map<std::string, double> expected{
        {"index_cmc", 68.1},  {"index_mcp", 39.8},  {"index_pip", 22.4}, {"middle_cmc", 64.6}, {"middle_mcp", 44.6},
        {"middle_pip", 26.3}, {"ring_cmc", 58.0},   {"ring_mcp", 41.4},  {"ring_pip", 25.7},   {"little_cmc", 53.7},
        {"little_mcp", 32.7}, {"little_pip", 18.1}, {"thumb_cmc", 46.2}, {"thumb_mcp", 31.6},  {"thumb_ip", 21.7}};
    const core::Skeleton& skeleton = rightHand().skeleton;
    for (const auto& [name, lengthMm] : expected)
        EXPECT_NEAR(skeleton.bones[skeleton.boneIndex(name)].lengthMm, lengthMm, 0.1 * lengthMm) << name;
}

TEST(DemoHand, WeightsArePositiveAndSumToOne) {
    const core::SkinWeights& weights = rightHand().weights;
    ASSERT_EQ(weights.firstEntry.size(), rightHand().mesh.vertices.size() + 1);
    for (std::size_t v = 0; v + 1 < weights.firstEntry.size(); ++v) {
        double sum = 0;
        for (int e = weights.firstEntry[v]; e < weights.firstEntry[v + 1]; ++e) {
            EXPECT_GT(weights.entries[e].weight, 0);
            sum += weights.entries[e].weight;
        }
        EXPECT_NEAR(sum, 1, 1e-9);
    }
}

TEST(DemoHand, WeightsChangeSmoothlyAlongTheSurface) {
    const HandModel& hand = rightHand();
    const int bone = hand.skeleton.boneIndex("index_pip");
    const std::string name = hand.skeleton.bones[bone].name;
    for (const core::MeshEdge& edge : core::meshEdges(hand.mesh.triangles)) {
        const double change = weightOn(hand, edge.vertexA, name) - weightOn(hand, edge.vertexB, name);
        const double lengthMm = (hand.mesh.vertices[edge.vertexA] - hand.mesh.vertices[edge.vertexB]).norm();
        EXPECT_LT(std::abs(change) / lengthMm, 0.15);
    }
}

TEST(DemoHand, AFingerDoesNotDragItsNeighbours) {
    const HandModel& hand = rightHand();
    const std::vector<Vector3d> moved = core::posedVertices(
        hand, bent(hand, {{"middle_mcp.flexion", 70}, {"middle_pip.flexion", 80}, {"middle_dip.flexion", 40}}));
    int checked = 0;
    for (int v = 0; v < static_cast<int>(moved.size()); ++v) {
        const Vector3d& rest = hand.mesh.vertices[v];
        for (const char* finger : {"index", "ring"}) {
            const int mcp = hand.skeleton.boneIndex(std::string(finger) + "_mcp");
            const int tip = hand.skeleton.boneIndex(std::string(finger) + "_tip");
            const Vector3d from = hand.skeleton.bones[mcp].worldFromBoneAtRest.translation;
            const Vector3d to = hand.skeleton.bones[tip].worldFromBoneAtRest.translation;
            const Vector3d along = (to - from).normalized();
            const double t = (rest - from).dot(along);
            const bool isOnFinger = t > 32 && (rest - from - t * along).norm() < 11;
            if (isOnFinger) {
                EXPECT_LT((moved[v] - rest).norm(), 0.01) << finger << " vertex " << v;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 500);
}

TEST(DemoHand, FingersBendWithoutCollapsing) {
    for (const auto& [finger, joint] : std::vector<std::pair<std::string, std::string>>{{"index", "pip"},
                                                                                        {"middle", "pip"},
                                                                                        {"ring", "pip"},
                                                                                        {"little", "pip"},
                                                                                        {"index", "dip"},
                                                                                        {"thumb", "ip"}}) {
        const HandModel& hand = rightHand();
        const core::Bone& bone = hand.skeleton.bones[hand.skeleton.boneIndex(finger + "_" + joint)];
        const core::RigidMotion& rest = bone.worldFromBoneAtRest;
        const core::Bone& before = hand.skeleton.bones[bone.parent];
        const Vector3d along = (rest.rotation.col(0) + before.worldFromBoneAtRest.rotation.col(0)).normalized();
        const double straight = cutArea(hand, hand.skeleton.restPose(), finger, rest.translation, along);
        const Pose pose = bent(hand, {{finger + "_" + joint + ".flexion", 90}});
        const std::vector<core::RigidMotion> frames = core::boneTransforms(hand.skeleton, pose);
        const Vector3d bisector =
            (frames[hand.skeleton.boneIndex(bone.name)].rotation.col(0) + frames[bone.parent].rotation.col(0))
                .normalized();
        const double folded =
            cutArea(hand, pose, finger, frames[hand.skeleton.boneIndex(bone.name)].translation, bisector);
        EXPECT_GT(straight, 80) << finger;
        EXPECT_GE(folded, 0.6 * straight) << finger << " " << joint;
    }
}

TEST(DemoHand, TheLeftHandMirrorsTheRightOneInEveryPose) {
    Pose pose = rightHand().skeleton.restPose();
    for (Eigen::Index i = core::kRigidDofs; i < pose.size(); ++i)
        pose[i] = 0.1 + 0.3 * std::sin(static_cast<double>(i));
    const std::vector<Vector3d> right = core::posedVertices(rightHand(), pose);
    const std::vector<Vector3d> left = core::posedVertices(leftHand(), pose);
    for (std::size_t v = 0; v < right.size(); ++v)
        EXPECT_LT((right[v].cwiseProduct(Vector3d(1, -1, 1)) - left[v]).norm(), 1e-9);
    EXPECT_EQ(leftHand().side, core::Side::Left);
    for (const core::Bone& bone : leftHand().skeleton.bones)
        EXPECT_TRUE(core::isRotation(bone.worldFromBoneAtRest.rotation, 1e-9)) << bone.name;
}

} // namespace
