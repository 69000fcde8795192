// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/camera.h"
#include "core/io/calibration/calibration_notes.h"
#include "core/io/calibration/calibration_options.h"

namespace core {

/// A kind of calibration file, by the name that the command line uses.
struct CalibrationKind {
    std::string_view name;
    std::string_view description; ///< English, for lists
    double mmPerUnit = 1;         ///< the unit that such files are usually in
    bool canWrite = false;
    std::string_view endings = ""; ///< of the files that hold it: lower case, without dot, separated by spaces
};
/// All kinds, one row of the table in calibration.cpp each.
const std::vector<CalibrationKind>& calibrationKinds();

/// False if no kind has files that end so: such a file need not be opened.
bool mayBeCalibration(const std::filesystem::path& file);

/// Which kind of calibration a file or folder holds. Throws Error(Unsupported) if it is none of the known ones.
std::string sniffCalibration(const std::filesystem::path& path);

/// Reads cameras from a file, or from a folder for kinds that have a file per camera, and brings them to our
/// conventions: x_cam = R x_world + t in mm, pixel centres from 0, matrices not transposed. Cameras are named by the
/// file and sorted by name, numbers in names by value. Throws Error naming file and field, also if an image size is
/// needed and not given.
std::vector<Camera> readCalibration(const std::filesystem::path& path, const CalibrationOptions& options = {});

/// Writes all cameras into one file of that kind (mm). Throws Error(Usage) for a kind that cannot be written.
void writeCalibration(const std::filesystem::path& file, std::string_view kind, const std::vector<Camera>& cameras);

/// unitNote for cameras that readCalibration made of `path`, and a word on kinds whose files do not say their unit.
std::vector<std::string> calibrationNotes(const std::filesystem::path& path, const CalibrationOptions& options,
                                          const std::vector<Camera>& cameras);

} // namespace core
