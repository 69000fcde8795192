// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace core {

/// Looks through a glTF 2.0 file (.gltf with its buffers, or .glb) before the importer sees it, which trusts what it
/// reads: all indices in range, no node below itself, buffers as long as they say, joints of every vertex within their
/// skin. Throws Error naming the file and the field; Error(Unsupported) for compressed or sparse data.
void checkGltfFile(const std::filesystem::path& file);

} // namespace core
