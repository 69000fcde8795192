// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/dataset/dataset.h"
#include "tests/support/camera_ring.h"
#include "tests/support/small_hand.h"

namespace test {

struct SmallDataset {
    core::Dataset dataset;
    std::vector<core::Motion> motions;
};

/// Two small hands, three cameras, a sequence "first" of five frames with motion and one "second" of seven without
/// pictures.
SmallDataset smallDataset();

void writeSmallDataset(const std::filesystem::path& folder);

} // namespace test
