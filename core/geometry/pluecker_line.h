// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace core {

/// A line in space in Pluecker coordinates: unit direction d and moment m = p x d for any p on it (mm).
struct PlueckerLine {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();

    /// The line through `point` along `directionAny` (any length but 0).
    static PlueckerLine through(const Eigen::Vector3d& point, const Eigen::Vector3d& directionAny) {
        const Eigen::Vector3d d = directionAny.normalized();
        return {d, point.cross(d)};
    }

    /// p x d - m: its norm is the distance of `point` from the line, in mm.
    Eigen::Vector3d offset(const Eigen::Vector3d& point) const { return point.cross(direction) - moment; }

    /// The point of the line that is nearest to the origin.
    Eigen::Vector3d pointNearestOrigin() const { return direction.cross(moment); }
};

} // namespace core
