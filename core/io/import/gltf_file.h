// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace core {

/// A glTF 2.0 file taken apart: its JSON and the bytes of its buffers.
struct GltfFile {
    std::filesystem::path path;
    nlohmann::json root;
    std::vector<std::string> buffers; ///< exactly as long as their byteLength says
};

/// Reads a .gltf with its buffers (base64 or files beside it) or a .glb. Throws Error naming the file and the field: a
/// container or buffer that is cut off, another version of glTF.
GltfFile readGltfFile(const std::filesystem::path& path);

} // namespace core
