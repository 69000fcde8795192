// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/hand/hand_model.h"

namespace core {

/// A bone as a capsule: all points within radiusMm of a segment that is fixed in the bone.
struct BoneCapsule {
    int bone = 0;
    int finger = 0;              ///< the first bone of its chain below the root
    bool isPalm = false;         ///< a metacarpal, by its name (thumb_cmc)
    Eigen::Vector3d startAtRest; ///< in the mesh's frame, mm
    Eigen::Vector3d endAtRest;
    double radiusMm = 0;
};

/// The capsules of all bones but the root that own skin: from the joint to the next one, or to within the radius of the
/// tip. The radius is the median distance of the vertices that the bone moves most. None for rigid hands.
std::vector<BoneCapsule> boneCapsules(const HandModel& hand);

/// Two capsules that should not penetrate each other: of two hands, or of different fingers of one hand and not both in
/// its palm.
struct CapsulePair {
    int handA = 0, a = 0, handB = 0, b = 0; ///< indices of hands and of their capsules
    double allowedMm = 0;                   ///< of one hand: the depth that the rest pose has, too
};
struct HandCapsules {
    std::vector<std::vector<BoneCapsule>> capsules; ///< per hand
    std::vector<CapsulePair> pairs;
};
HandCapsules handCapsules(const std::vector<HandModel>& hands);

/// How deep two capsules penetrate each other, beyond what is allowed.
struct CapsuleOverlap {
    int handA = 0, boneA = 0, handB = 0, boneB = 0;
    double depthMm = 0;
    Eigen::Vector3d pointA, pointB; ///< the closest points of the segments, in the world, mm
    Eigen::Vector3d apart;          ///< unit, in the world: moving A along it and B against it lessens the depth
};
/// The overlaps in these poses, depths above 0, in the order of the pairs.
std::vector<CapsuleOverlap> capsuleOverlaps(const HandCapsules& capsules, const std::vector<HandModel>& hands,
                                            const HandPoses& poses);

/// Derivative of the depth by the tangent step of `retract` of one hand, the other one held, mm per mm or rad; points
/// stay fixed in their bones, which is exact to first order, as they are the closest ones. axes: of that hand.
Eigen::RowVectorXd overlapJacobian(const CapsuleOverlap& overlap, int hand, const Skeleton& skeleton,
                                   const DofAxes& axes);

/// Adds the overlaps that one hand in that pose takes part in, weight / 2 depth^2 each, to its normal equations, whose
/// size says how many degrees of freedom move.
void addOverlaps(const std::vector<CapsuleOverlap>& overlaps, int hand, const Skeleton& skeleton, const Pose& pose,
                 double weight, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient);

} // namespace core
