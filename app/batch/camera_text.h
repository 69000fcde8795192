// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/camera.h"

namespace app {

/// Prints what a person needs to see to know that a calibration was understood: sizes, focal lengths, and how far each
/// camera is from where all of them look.
void printCameras(const std::vector<core::Camera>& cameras);

} // namespace app
