// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/rigid_motion.h"
#include "core/hand/triangle_mesh.h"

namespace test {

/// A ring of a surface of revolution about x.
struct Ring {
    double x;
    double radius;
};

/// The closed surface through the rings, in ascending x, with a pole at either end; outward.
core::TriangleMesh surfaceOfRevolution(const std::vector<Ring>& rings, double firstX, double lastX, int sectors);

/// An axis-aligned ellipsoid; its poles lie on x.
core::TriangleMesh ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii, int rings, int sectors);

core::TriangleMesh ball(const Eigen::Vector3d& centre, double radius, int rings = 48, int sectors = 96);

/// A rod with round ends whose axis runs from 0 to length along x.
core::TriangleMesh capsule(double length, double radius, double ringStep, int sectors);

core::TriangleMesh moved(core::TriangleMesh mesh, const core::RigidMotion& motion);

void append(core::TriangleMesh& mesh, const core::TriangleMesh& part);

} // namespace test
