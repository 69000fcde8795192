// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/camera.h"

namespace core {

/// What is odd about the length unit of cameras that were read with `mmPerUnit` (readCalibration's, resolved), with the
/// --mm-per-unit that would mend it, English; empty if nothing is. Cameras that are less than 100 mm (or more than 200
/// m) from where they look are of another unit.
std::string unitNote(const std::vector<Camera>& cameras, double mmPerUnit = 1);

/// Which cameras have a lens model that folds back within the image, and in how much of the image it holds, English:
/// there, pixels have no viewing ray, and points are not shown.
std::vector<std::string> lensNotes(const std::vector<Camera>& cameras);

} // namespace core
