// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/camera.h"
#include "core/geometry/triangulation.h"

namespace core {

/// A point to triangulate: its name and where cameras see it.
struct PointClicks {
    std::string id;
    std::vector<Observation> observations; ///< at most one per camera
};

/// Reads {"points": [{"id", "views": [{"camera", "px": [x, y]}]}]}. Throws Error naming the file and the field, also
/// for a camera that is not in `cameras` or occurs twice in a point.
std::vector<PointClicks> readPointClicks(const std::filesystem::path& file, const std::vector<Camera>& cameras);

/// Writes {"points": [{"id", "xyz", "covariance", "rmsPx", "inliers", "outliers", "reason"}]}; xyz, covariance and
/// rmsPx are null where there is no point. `results` is parallel to `points`.
void writeTriangulatedPoints(const std::filesystem::path& file, const std::vector<Camera>& cameras,
                             const std::vector<PointClicks>& points, const std::vector<TriangulationResult>& results);

} // namespace core
