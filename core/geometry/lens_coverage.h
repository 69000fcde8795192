// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/camera.h"

namespace core {

/// The part of the image, from 0 to 1, whose pixels have a viewing ray: less than 1 if the lens model folds back within
/// the image. Found on a grid of 100 x 100 pixels.
double lensCoverage(const Camera& camera);

} // namespace core
