// SPDX-License-Identifier: MIT
#include "core/hand/hand_model.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace core {

namespace {

/// worldFromBone(pose) * boneFromWorld(rest) of every bone.
std::vector<RigidMotion> skinningTransforms(const Skeleton& skeleton, const Pose& pose) {
    std::vector<RigidMotion> transforms = boneTransforms(skeleton, pose);
    for (std::size_t b = 0; b < transforms.size(); ++b)
        transforms[b] = transforms[b] * inverse(skeleton.bones[b].worldFromBoneAtRest);
    return transforms;
}

} // namespace

RigidMotion worldFromRest(const HandModel& hand, const Pose& pose) {
    return boneTransforms(hand.skeleton, pose).front() * inverse(hand.skeleton.bones.front().worldFromBoneAtRest);
}

std::vector<Eigen::Vector3d> posedVertices(const HandModel& hand, const Pose& pose) {
    const std::vector<RigidMotion> transforms = skinningTransforms(hand.skeleton, pose);
    std::vector<Eigen::Vector3d> posed(hand.mesh.vertices.size());
    for (std::size_t v = 0; v < posed.size(); ++v) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int e = hand.weights.firstEntry[v]; e < hand.weights.firstEntry[v + 1]; ++e) {
            const SkinWeight& w = hand.weights.entries[e];
            sum += w.weight * (transforms[w.bone] * hand.mesh.vertices[v]);
        }
        posed[v] = sum;
    }
    return posed;
}

Eigen::MatrixXd vertexJacobian(const HandModel& hand, const Pose& pose, int vertex) {
    const Skeleton& skeleton = hand.skeleton;
    const std::vector<RigidMotion> transforms = skinningTransforms(skeleton, pose);
    const DofAxes axes = dofAxes(skeleton, pose);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, skeleton.poseSize());
    for (int e = hand.weights.firstEntry[vertex]; e < hand.weights.firstEntry[vertex + 1]; ++e) {
        const SkinWeight& w = hand.weights.entries[e];
        const Eigen::Vector3d carried = transforms[w.bone] * hand.mesh.vertices[vertex];
        for (int k = 0; k < 3; ++k) {
            jacobian.col(k) += w.weight * axes.axisInWorld[k];
            jacobian.col(k + 3) += w.weight * axes.axisInWorld[k + 3].cross(carried - axes.pointInWorld[k + 3]);
        }
        for (int ancestor = w.bone; ancestor >= 0; ancestor = skeleton.bones[ancestor].parent) {
            for (std::size_t d = 0; d < skeleton.dofs.size(); ++d) {
                if (skeleton.dofs[d].bone == ancestor) {
                    const std::size_t c = kRigidDofs + d;
                    jacobian.col(static_cast<Eigen::Index>(c)) +=
                        w.weight * axes.axisInWorld[c].cross(carried - axes.pointInWorld[c]);
                }
            }
        }
    }
    return jacobian;
}

SkinWeights compressedWeights(const SkinWeights& weights, int maxPerVertex, double threshold) {
    SkinWeights result;
    result.firstEntry.push_back(0);
    for (std::size_t v = 0; v + 1 < weights.firstEntry.size(); ++v) {
        std::vector<SkinWeight> kept(weights.entries.begin() + weights.firstEntry[v],
                                     weights.entries.begin() + weights.firstEntry[v + 1]);
        std::stable_sort(kept.begin(), kept.end(),
                         [](const SkinWeight& a, const SkinWeight& b) { return a.weight > b.weight; });
        while (kept.size() > 1 && (static_cast<int>(kept.size()) > maxPerVertex || kept.back().weight < threshold))
            kept.pop_back();
        double sum = 0;
        for (const SkinWeight& w : kept)
            sum += w.weight;
        for (const SkinWeight& w : kept)
            result.entries.push_back({w.bone, w.weight / sum});
        result.firstEntry.push_back(static_cast<int>(result.entries.size()));
    }
    return result;
}

double meanJointDistanceMm(const std::vector<HandModel>& hands, const HandPoses& a, const HandPoses& b) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        const auto jointsA = jointPositions(hands[h].skeleton, a[h]);
        const auto jointsB = jointPositions(hands[h].skeleton, b[h]);
        for (std::size_t j = 0; j < jointsA.size(); ++j)
            sum += (jointsA[j] - jointsB[j]).norm();
        count += jointsA.size();
    }
    return count ? sum / static_cast<double>(count) : 0;
}

} // namespace core
