// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/hand/triangle_mesh.h"

namespace core {

/// Reads a triangle mesh (OFF) through assimp. Vertices keep their order and none are merged, so that per-vertex files
/// beside it still fit. Throws Error if it is not a mesh, not all triangles, or its counts are not those of its header.
TriangleMesh readOffMesh(const std::filesystem::path& file);

} // namespace core
