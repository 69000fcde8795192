// SPDX-License-Identifier: MIT
#include "core/io/demo/demo_dataset.h"

#include <nlohmann/json.hpp>

#include "core/demo_hand/choreography.h"
#include "core/demo_hand/demo_hand.h"
#include "core/geometry/camera_ring.h"
#include "core/io/demo/demo_files.h"
#include "core/io/files/embedded_resources.h"
#include "core/io/hands/rig_file.h"

namespace core {

std::vector<HandModel> makeDemoHands() {
    const DemoHandShape shape = demoHandShapeFromJson(embeddedOwnFile("demo/hand.json", "demo-hand"));
    const HandModel right = makeDemoHand(shape, defaultRig("handlens"));
    return {mirroredHand(right), right};
}

std::vector<Choreography> demoChoreographies(const std::vector<HandModel>& hands) {
    const std::string name = "demo/choreographies.json";
    return choreographiesFromJson(embeddedOwnFile(name, "demo-choreographies"), hands, name);
}

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
    const std::vector<HandModel> hands = makeDemoHands();
    NewDataset demo = playedDataset(hands, demoChoreographies(hands));
    demo.dataset.name = "demo";
    return demo;
}

} // namespace core
