// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/dataset/dataset.h"
#include "tests/support/camera_ring.h"

namespace test {

/// A dataset in memory, without hands: cameras on a ring and one sequence "01" of 300 frames.
core::Dataset ringDataset(int cameraCount = 8);

} // namespace test
