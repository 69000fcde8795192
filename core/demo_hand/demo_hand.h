// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/hand/hand_model.h"
#include "core/demo_hand/implicit_surface.h"
#include "core/hand/rig.h"
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

/// The solid of the demo hand, and where a point lies along each ray.
class DemoHandSolid {
public:
    explicit DemoHandSolid(const DemoHandShape& shape);

    double distance(const Eigen::Vector3d& point) const;
    /// Per ray: distance to that ray's flesh, and the place along its joints (0 = CMC, 1 = MCP, ...).
    std::vector<SweepPosition> alongRays(const Eigen::Vector3d& point) const;
    /// How long the edges of the surface should be here: short on the fingers, longer on palm and forearm.
    double edgeLengthMm(const Eigen::Vector3d& point) const;
    /// A box around the solid.
    Eigen::AlignedBox3d bounds() const;

private:
    double padDistance(const PadShape& pad, const Eigen::Vector3d& point) const;

    DemoHandShape m_shape;
    std::vector<SweptSolid> m_metacarpals;
    std::vector<SweptSolid> m_digits;
    std::vector<SweptSolid> m_wholeRays;
    SweptSolid m_forearm;
};

/// The demo hand: its closed surface, its skeleton by `rig` (whose joints must be wrist and those of the rays, named
/// FINGER_cmc, FINGER_mcp, ...) and smooth weights. Deterministic.
HandModel makeDemoHand(const DemoHandShape& shape, const Rig& rig);

/// The same hand of the other side, mirrored at the plane y = 0. The same pose angles mean the same movement.
HandModel mirroredHand(const HandModel& hand);

} // namespace core
