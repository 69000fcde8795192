// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/geometry/camera.h"

namespace core {

/// Cameras.txt of the method's authors: K and [R|t] per camera, named cam0, cam1, ...; it holds no size: `size`, or
/// twice the principal point plus one.
std::vector<Camera> readTzionasCameras(const std::filesystem::path& file, std::optional<ImageSize> size = {});

} // namespace core
