// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/demo_hand/swept_solid.h"

namespace core {

/// One finger with its metacarpal: the joints it runs through and the flesh around them.
struct RayShape {
    std::string finger;
    std::vector<Eigen::Vector3d> joints; ///< from the CMC to the tip, rest pose
    Eigen::Vector3d dorsal;              ///< towards its back (the nail's side)
    SweptSolidShape metacarpal;
    SweptSolidShape digit;
    std::vector<double> bendMm; ///< per joint but the tip: half the length over which the skin bends
};

/// Names of a ray's joints: thumb_cmc, thumb_mcp, thumb_ip, thumb_tip; index_cmc, ..., index_tip.
std::vector<std::string> rayJointNames(const RayShape& ray);

/// A cushion of the palm: an ellipsoid.
struct PadShape {
    std::string name;
    Eigen::Vector3d centre;
    Eigen::Vector3d along;  ///< direction of its first axis
    Eigen::Vector3d dorsal; ///< its third axis is as near to this as the first one allows
    Eigen::Vector3d radiiMm;
};

/// Everything that the demo hand is made from: a right hand at rest, mm, wrist at the origin, x towards the fingers,
/// y towards the thumb, z towards the back of the hand.
struct DemoHandShape {
    std::vector<RayShape> rays; ///< thumb first
    std::vector<Eigen::Vector3d> forearmPath;
    SweptSolidShape forearm;
    std::vector<PadShape> pads;
    double palmBlendMm = 0; ///< widths over which parts melt into each other
    double padBlendMm = 0;
    double webBlendMm = 0;    ///< between neighbouring fingers
    double fingerBlendMm = 0; ///< between fingers and palm
    double thumbBlendMm = 0;
    double gridStepMm = 0;   ///< of the first, fine surface
    double fingerEdgeMm = 0; ///< wanted edge length on the fingers
    double palmEdgeMm = 0;   ///< on palm and forearm
    int relaxations = 0;
};

} // namespace core
