// SPDX-License-Identifier: MIT
#include "core/io/demo/demo_hands.h"

#include <nlohmann/json.hpp>

#include "core/demo_hand/demo_hand.h"
#include "core/io/demo/demo_files.h"
#include "core/io/files/embedded_resources.h"
#include "core/io/hands/rig_file.h"

namespace core {

namespace {

std::vector<HandModel> makeHands() {
    const DemoHandShape shape = demoHandShapeFromJson(embeddedOwnFile("demo/hand.json", "demo-hand"));
    const HandModel right = makeDemoHand(shape, defaultRig("handlens"));
    return {mirroredHand(right), right};
}

} // namespace

const std::vector<HandModel>& demoHands() {
    static const std::vector<HandModel> kHands = makeHands();
    return kHands;
}

std::vector<Choreography> demoChoreographies(const std::vector<HandModel>& hands) {
    const std::string name = "demo/choreographies.json";
    return choreographiesFromJson(embeddedOwnFile(name, "demo-choreographies"), hands, name);
}

} // namespace core
