// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/dataset/dataset.h"
#include "tests/support/camera_ring.h"

namespace test {

/// A dataset in memory, without hands: cameras on a ring and one sequence "01" of 300 frames.
inline core::Dataset ringDataset(int cameraCount = 8) {
    core::Dataset dataset;
    dataset.folder = "/nowhere";
    dataset.name = "ring";
    dataset.cameras = cameraRing(cameraCount);
    core::Sequence sequence;
    sequence.name = "01";
    sequence.frameCount = 300;
    sequence.annotations = "annotations/01.sqlite";
    dataset.sequences = {sequence};
    return dataset;
}

} // namespace test
