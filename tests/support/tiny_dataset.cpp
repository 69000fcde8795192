// SPDX-License-Identifier: MIT
#include "tests/support/tiny_dataset.h"

namespace test {

core::Dataset tinyDataset(int cameras) {
    core::Dataset dataset;
    dataset.name = "tiny";
    dataset.cameras = cameraRing(cameras);
    for (core::Camera& camera : dataset.cameras) {
        camera.size = {270, 480};
        camera.intrinsics.topRows<2>() *= 0.25;
    }
    dataset.hands = tinyHands();
    dataset.handFiles = {"hands/left.json", "hands/right.json"};
    const std::pair<const char*, int> sequences[] = {{"a", 30}, {"b", 10}};
    for (const auto& [name, frames] : sequences) {
        core::Sequence sequence;
        sequence.name = name;
        sequence.frameCount = frames;
        for (const core::Camera& camera : dataset.cameras)
            sequence.views.push_back({camera.name, core::ViewKind::Rendered, "", 0});
        sequence.motion = std::string("motion/") + name + ".json";
        sequence.annotations = std::string("annotations/") + name + ".sqlite";
        dataset.sequences.push_back(sequence);
    }
    return dataset;
}

void writeTinyDataset(const std::filesystem::path& folder, int cameras) {
    core::writeDataset(tinyDataset(cameras), {tinyMotion(30), tinyMotion(10)}, folder);
}

} // namespace test
