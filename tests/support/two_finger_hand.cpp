// SPDX-License-Identifier: MIT
#include "tests/support/two_finger_hand.h"

#include <algorithm>
#include <string>

#include <Eigen/Geometry>

#include "tests/support/shapes/solids.h"

namespace test {

core::HandModel rigidHand(core::TriangleMesh mesh) {
    core::HandModel hand;
    hand.mesh = std::move(mesh);
    hand.skeleton.bones = {{"wrist", -1, {}, 50}};
    for (std::size_t v = 0; v <= hand.mesh.vertices.size(); ++v)
        hand.weights.firstEntry.push_back(static_cast<int>(v));
    hand.weights.entries.assign(hand.mesh.vertices.size(), {0, 1.0});
    return hand;
}

namespace {

/// A finger of two bones, in the frame of the hand.
struct FingerPlan {
    std::string firstJoint, secondJoint;
    Eigen::Vector3d base, along;
    double firstMm, secondMm, radiusMm;
};

/// Weight of the farther of two bones `mm` beyond the joint between them: smooth over 10 mm on both sides.
double bendWeight(double mm) {
    const double u = std::clamp((mm + 10) / 20, 0.0, 1.0);
    return u * u * (3 - 2 * u);
}

void addFinger(core::HandModel& hand, const FingerPlan& plan, const core::RigidMotion& worldFromHand) {
    const core::RigidMotion handFromFinger{
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), plan.along).toRotationMatrix(), plan.base};
    const core::RigidMotion worldFromFirst = worldFromHand * handFromFinger;
    // The second bone's frame is turned a little against the first one's, as those of real hands are.
    const core::RigidMotion worldFromSecond =
        worldFromFirst * core::RigidMotion{core::rotationExp({0.1, 0, 0}), {plan.firstMm, 0, 0}};
    const int first = static_cast<int>(hand.skeleton.bones.size());
    hand.skeleton.bones.push_back({plan.firstJoint, 0, worldFromFirst, plan.firstMm});
    hand.skeleton.bones.push_back({plan.secondJoint, first, worldFromSecond, plan.secondMm});
    hand.skeleton.dofs.push_back({plan.firstJoint + ".flexion", first, Eigen::Vector3d::UnitY(), -0.8, 0.9});
    hand.skeleton.dofs.push_back({plan.firstJoint + ".abduction", first, Eigen::Vector3d::UnitZ(), -0.5, 0.5});
    hand.skeleton.dofs.push_back({plan.secondJoint + ".flexion", first + 1, Eigen::Vector3d::UnitY(), -0.6, 1.1});

    const core::TriangleMesh skin = capsule(plan.firstMm + plan.secondMm, plan.radiusMm, 2.5, 24);
    append(hand.mesh, moved(skin, worldFromFirst));
    for (const Eigen::Vector3d& v : skin.vertices) {
        const double moves = bendWeight(v.x()), bends = bendWeight(v.x() - plan.firstMm);
        const std::array<double, 3> weights{1 - moves, moves * (1 - bends), moves * bends};
        const std::array<int, 3> bones{0, first, first + 1};
        for (std::size_t k = 0; k < 3; ++k)
            if (weights[k] > 0)
                hand.weights.entries.push_back({bones[k], weights[k]});
        hand.weights.firstEntry.push_back(static_cast<int>(hand.weights.entries.size()));
    }
}

/// Takes a pose as the new rest pose: a relaxed hand's fingers are not straight, and surfaces bend at their joints.
void restAt(core::HandModel& hand, const core::Pose& pose) {
    const std::vector<core::RigidMotion> worldFromBone = core::boneTransforms(hand.skeleton, pose);
    hand.mesh.vertices = core::posedVertices(hand, pose);
    for (std::size_t b = 0; b < worldFromBone.size(); ++b)
        hand.skeleton.bones[b].worldFromBoneAtRest = worldFromBone[b];
}

} // namespace

core::HandModel twoFingerHand(core::Side side, const core::RigidMotion& worldFromHand) {
    core::HandModel hand;
    hand.side = side;
    hand.skeleton.bones.push_back({"wrist", -1, worldFromHand, 70});
    hand.skeleton.centreAtRest = worldFromHand * Eigen::Vector3d(45, 5, 0);
    hand.mesh = moved(ellipsoid({35, 0, 0}, {48, 36, 14}, 24, 36), worldFromHand);
    hand.weights.firstEntry.push_back(0);
    for (std::size_t v = 0; v < hand.mesh.vertices.size(); ++v) {
        hand.weights.entries.push_back({0, 1.0});
        hand.weights.firstEntry.push_back(static_cast<int>(v) + 1);
    }
    addFinger(hand, {"index_mcp", "index_pip", {70, 8, 0}, {1, 0.1, 0}, 42, 32, 9}, worldFromHand);
    addFinger(hand, {"thumb_mcp", "thumb_ip", {25, 28, 2}, {0.6, 0.8, 0.1}, 36, 30, 10}, worldFromHand);
    core::Pose relaxed = hand.skeleton.restPose();
    relaxed.tail(6) << 0.3, 0, 0.5, 0.2, 0, 0.4;
    restAt(hand, relaxed);
    return hand;
}

std::vector<core::HandModel> twoFingerHands() {
    return {twoFingerHand(core::Side::Left, {core::rotationExp({0, 0, 0.2}), {-70, -10, -25}}),
            twoFingerHand(core::Side::Right, {core::rotationExp({0, 3.0, 0}), {70, 5, 25}})};
}

core::Pose somePose(const core::Skeleton& skeleton, RandomValues& random, double rigidMm, double rigidRad) {
    core::Pose pose(skeleton.poseSize());
    pose << random.point(rigidMm), rigidRad * random.direction(),
        Eigen::VectorXd::Zero(skeleton.poseSize() - core::kRigidDofs);
    for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
        pose[core::kRigidDofs + static_cast<Eigen::Index>(d)] =
            random.between(0.7 * skeleton.dofs[d].minRad, 0.7 * skeleton.dofs[d].maxRad);
    }
    return pose;
}

} // namespace test
