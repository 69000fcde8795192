// SPDX-License-Identifier: MIT
#include "tests/support/recordings/ring_dataset.h"

namespace test {

core::Dataset ringDataset(int cameraCount) {
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
