// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"

namespace core {

/// The cameras files of a dataset that it could use: files in the folder of the one in use, of its kind, with the same
/// cameras (names in order, picture sizes). Relative to the dataset's folder, in the order of their names; the one in
/// use is always among them.
std::vector<std::string> calibrationFiles(const Dataset& dataset);

/// Writes `cameras` as a new file beside the calibration in use ("cameras-refined-1.json" beside "cameras.json", the
/// next free number) and makes the dataset use it. The old file stays as it is. Returns the dataset as it is then; with
/// an error (Error is thrown) nothing has changed. `cameras` must be the dataset's (names in order, sizes).
Dataset addCalibration(const std::filesystem::path& folder, const std::vector<Camera>& cameras);

/// Makes the dataset use another of its calibrationFiles(). Returns the dataset as it is then. Throws Error, and then
/// nothing has changed.
Dataset useCalibration(const std::filesystem::path& folder, const std::string& file);

} // namespace core
