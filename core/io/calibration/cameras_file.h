// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/geometry/camera.h"

namespace core {

/// Reads a cameras file (format "handlens-cameras"). Throws Error naming the file and the field.
std::vector<Camera> readCameras(const std::filesystem::path& file);
/// The same of a file that is already parsed; `file` is named in errors.
std::vector<Camera> camerasFromJson(const nlohmann::json& document, const std::string& file);
void writeCameras(const std::filesystem::path& file, const std::vector<Camera>& cameras);

/// The list of cameras as it stands in a cameras file and in exports.
nlohmann::ordered_json camerasToJson(const std::vector<Camera>& cameras);
/// The whole content of a cameras file.
nlohmann::ordered_json camerasDocument(const std::vector<Camera>& cameras);

/// Everything that must hold for cameras of whatever origin: distinct names that can name a file, a positive size, K
/// upper triangular with positive focal lengths, a known number of lens coefficients, a proper rotation. Throws
/// Error(BadInput) naming `file` and the camera.
void checkCameras(const std::vector<Camera>& cameras, const std::string& file);

} // namespace core
