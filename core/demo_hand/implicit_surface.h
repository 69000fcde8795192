// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/hand/triangle_mesh.h"

namespace core {

/// A solid: negative inside, positive outside, about the distance to its surface in mm near it.
using SolidField = std::function<double(const Eigen::Vector3d& point)>;

/// Smooth minimum of two distances: C2, equal to the plain minimum where they differ by more than `widthMm`,
/// at most widthMm / 6 below it (a rounded union of two solids).
double smoothMin(double a, double b, double widthMm);

/// The closed, outward oriented surface around `inside`, a point of the solid, by marching tetrahedra (six per cube, so
/// there are no ambiguous cases) from cube to cube along the surface. `box` must contain the solid with a margin of at
/// least one step. Empty if `inside` is not inside.
TriangleMesh polygonise(const SolidField& field, const Eigen::AlignedBox3d& box, double stepMm,
                        const Eigen::Vector3d& inside);

} // namespace core
