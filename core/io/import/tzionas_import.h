// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/geometry/camera.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// What to import: see the fields.
struct TzionasImportOptions {
    std::vector<std::filesystem::path> sequenceFolders; ///< each one sequence, named after its folder
    std::filesystem::path modelFiles;   ///< where OFF, SKIN, LIMITS are if not in the sequence folders; may be empty
    std::filesystem::path camerasFile;  ///< Cameras.txt; empty = a ring of cameras
    std::optional<ImageSize> imageSize; ///< for Cameras.txt, which holds none
    int ringCameras = 8;
};

/// A dataset ready to be written, and how closely its poses reproduce the recorded bone origins.
struct ImportedDataset {
    Dataset dataset;
    std::vector<Motion> motions; ///< parallel to dataset.sequences
    double meanErrorMm = 0;
    double maxErrorMm = 0;
};

/// Called with the number of finished and of all frames.
using ImportProgress = std::function<void(int done, int total)>;

/// Reads the hands and motions of the method's authors (OFF, SKEL, SKIN, LIMITS, MOTION, Cameras.txt), files in the
/// sequence folders or the common ones in `modelFiles`. Poses are fitted to the recorded bone poses and never clamped
/// to the limits. The world is MOTION's. Throws Error naming the file at fault; Error(Usage) when stopped.
ImportedDataset importTzionas(const TzionasImportOptions& options, std::stop_token stop = {},
                              const ImportProgress& progress = {});

} // namespace core
