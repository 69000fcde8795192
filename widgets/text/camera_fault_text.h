// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QString>

#include "core/geometry/camera_faults.h"

namespace widgets {

/// What is wrong with a calibration, in a sentence: "cam2: its rotation is a mirror (determinant -1)".
QString cameraFaultText(const core::CameraFault& fault, const std::vector<core::Camera>& cameras);

} // namespace widgets
