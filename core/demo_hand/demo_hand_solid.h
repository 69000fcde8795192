// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/demo_hand/demo_hand_shape.h"
#include "core/demo_hand/swept_solid.h"

namespace core {

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

} // namespace core
