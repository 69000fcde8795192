// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/hand/skeleton.h"
#include "core/hand/triangle_mesh.h"

namespace core {

/// Weight of one bone on one vertex.
struct SkinWeight {
    int bone;
    double weight;
};

/// Skinning weights of all vertices, row-compressed: vertex v owns entries[firstEntry[v] .. firstEntry[v + 1]).
/// The weights of a vertex are positive and sum to 1.
struct SkinWeights {
    std::vector<int> firstEntry;
    std::vector<SkinWeight> entries;
};

/// A skinned hand: surface and skeleton in the rigging pose, and the weights that tie them.
struct HandModel {
    Side side = Side::Left;
    TriangleMesh mesh;
    Skeleton skeleton;
    SkinWeights weights;
};

/// One pose per hand, in the order of the dataset's hands.
using HandPoses = std::vector<Pose>;

/// How a pose moves the hand's root bone, from the rest pose into the world.
RigidMotion worldFromRest(const HandModel& hand, const Pose& pose);

/// Linear blend skinning: v(pose) = sum_b weight_b * worldFromBone(pose) * boneFromWorld(rest) * v (mm).
std::vector<Eigen::Vector3d> posedVertices(const HandModel& hand, const Pose& pose);

/// Derivative of one posed vertex by the tangent step of `retract`: 3 x poseSize.
Eigen::MatrixXd vertexJacobian(const HandModel& hand, const Pose& pose, int vertex);

/// Drops weights below `threshold`, keeps at most `maxPerVertex` largest, and renormalises.
SkinWeights compressedWeights(const SkinWeights& weights, int maxPerVertex, double threshold);

/// Mean Euclidean distance over all joints of all hands between two sets of poses, mm.
double meanJointDistanceMm(const std::vector<HandModel>& hands, const HandPoses& a, const HandPoses& b);

} // namespace core
