// SPDX-License-Identifier: MIT
#include "core/io/demo/demo_dataset.h"

#include "core/geometry/camera_ring.h"

namespace core {

NewDataset playedDataset(const std::vector<HandModel>& hands, const std::vector<Choreography>& choreographies) {
    NewDataset played;
    Dataset& dataset = played.dataset;
    dataset.hands = hands;
    dataset.handFiles = {"hands/left.json", "hands/right.json"};
    for (const Choreography& choreography : choreographies) {
        Sequence sequence;
        sequence.name = choreography.name;
        sequence.frameCount = choreography.frameCount;
        sequence.motion = "motion/" + sequence.name + ".json";
        sequence.annotations = "annotations/" + sequence.name + ".sqlite";
        dataset.sequences.push_back(std::move(sequence));
        played.motions.push_back(play(choreography, dataset.hands));
    }
    dataset.cameras = cameraRing(recordedVolume(dataset.hands, played.motions));
    addRenderedViews(dataset);
    return played;
}

NewDataset makeDemoDataset() {
    const std::vector<HandModel>& hands = demoHands();
    NewDataset demo = playedDataset(hands, demoChoreographies(hands));
    demo.dataset.name = "demo";
    return demo;
}

} // namespace core
