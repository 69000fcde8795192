// SPDX-License-Identifier: MIT
#include "core/io/demo_dataset.h"

#include <nlohmann/json.hpp>

#include "core/geometry/camera_ring.h"
#include "core/hand/choreography.h"
#include "core/hand/demo_hand.h"
#include "core/io/demo_files.h"
#include "core/io/embedded_resources.h"
#include "core/io/rig_file.h"

namespace core {

std::vector<HandModel> makeDemoHands() {
    const DemoHandShape shape = demoHandShapeFromJson(embeddedOwnFile("demo/hand.json", "demo-hand"));
    const HandModel right = makeDemoHand(shape, defaultRig("handlens"));
    return {mirroredHand(right), right};
}

NewDataset makeDemoDataset() {
    const std::string name = "demo/choreographies.json";
    const nlohmann::json choreographies = embeddedOwnFile(name, "demo-choreographies");
    NewDataset demo;
    Dataset& dataset = demo.dataset;
    dataset.name = "demo";
    dataset.hands = makeDemoHands();
    dataset.handFiles = {"hands/left.json", "hands/right.json"};
    for (const Choreography& choreography : choreographiesFromJson(choreographies, dataset.hands, name)) {
        Sequence sequence;
        sequence.name = choreography.name;
        sequence.frameCount = choreography.frameCount;
        sequence.framesPerSecond = choreographies["framesPerSecond"].get<double>();
        sequence.motion = "motion/" + sequence.name + ".json";
        sequence.annotations = "annotations/" + sequence.name + ".sqlite";
        dataset.sequences.push_back(std::move(sequence));
        demo.motions.push_back(play(choreography, dataset.hands));
    }
    dataset.cameras = cameraRing(recordedVolume(dataset.hands, demo.motions));
    addRenderedViews(dataset);
    return demo;
}

} // namespace core
