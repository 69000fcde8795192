// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/demo_hand/implicit_surface.h"

namespace core {

/// Wanted length of an edge at a place of the surface, mm.
using EdgeLengthField = std::function<double(const Eigen::Vector3d& point)>;

/// Makes the triangles of a closed surface even and of the wanted size (Botsch and Kobbelt 2004, without splits, so the
/// mesh must be finer than wanted): short edges collapse, edges flip towards valence six, vertices move to the
/// middle of their neighbours and back onto the solid. The result is as closed and as oriented as the mesh given.
TriangleMesh remeshed(const SolidField& field, TriangleMesh mesh, const EdgeLengthField& edgeLength, int iterations);

/// One pass of collapses of edges shorter than 0.8 times the wanted length, shortest first; only such as leave a
/// closed surface (two common neighbours) and turn no triangle over. Returns how many there were.
int collapseShortEdges(TriangleMesh& mesh, const EdgeLengthField& edgeLength);

/// One pass of flips of edges between nearly coplanar triangles, where that brings the valences closer to six.
int flipEdges(TriangleMesh& mesh);

/// Moves every vertex towards the middle of its neighbours along the surface, then onto the solid.
void relaxOnto(const SolidField& field, TriangleMesh& mesh);

} // namespace core
