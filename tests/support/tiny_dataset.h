// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/io/dataset/dataset.h"
#include "tests/support/camera_ring.h"
#include "tests/support/tiny_hands.h"

namespace test {

/// A small dataset with rendered views: the tiny hands, cameras of 270 x 480, sequences "a" (30 frames) and "b" (10
/// frames).
core::Dataset tinyDataset(int cameras = 8);

/// Writes it into a folder that does not exist yet.
void writeTinyDataset(const std::filesystem::path& folder, int cameras = 8);

} // namespace test
