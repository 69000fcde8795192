// SPDX-License-Identifier: MIT
#pragma once

#include "core/hand/hand_model.h"

namespace core {

/// A surface with its weights, on the way to a hand model.
struct WeightedSurface {
    TriangleMesh mesh;
    SkinWeights weights; ///< one row per vertex
};

/// Joins vertices at the same place (within `toleranceMm`) that have the same weights: files split them where normals
/// or texture coordinates differ. Triangles that lose a corner are dropped, and so are vertices without a triangle.
WeightedSurface welded(const WeightedSurface& surface, double toleranceMm = 1e-3);

/// Closes every hole whose border is a simple loop with a fan around the middle of the loop, whose weights are the mean
/// of the loop's. Holes of another kind stay.
WeightedSurface withHolesClosed(const WeightedSurface& surface);

} // namespace core
