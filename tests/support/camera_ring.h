// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/camera.h"

namespace test {

/// Cameras on a ring of 900 mm around the origin that look at it, alternately from above and below, with a lens of
/// moderate distortion (none if `withLens` is false), 1080 x 1920.
std::vector<core::Camera> cameraRing(int count, bool withLens = true);

} // namespace test
