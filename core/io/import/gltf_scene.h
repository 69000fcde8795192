// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/hand/mesh_repair.h"

namespace core {

/// A node of the scene's tree.
struct GltfNode {
    std::string name;
    int parent = -1;               ///< earlier in the list; -1 for the root
    Eigen::Affine3d worldFromNode; ///< at rest, mm
};

/// The parts of a glTF file that make up a skinned surface, in the pose that the file shows.
struct GltfScene {
    std::vector<GltfNode> nodes;
    WeightedSurface surface; ///< all skinned meshes; the bones of the weights are indices into `nodes`; mm
};

/// Reads a .gltf or .glb file through assimp, after checkGltfFile. glTF's metres become millimetres; its axes are kept.
/// Throws Error naming the file: not a glTF, no skinned mesh.
GltfScene readGltfScene(const std::filesystem::path& file);

} // namespace core
