// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/batch/verbs.h"
#include "core/io/dataset/dataset.h"
#include "core/io/files/json_file.h"

namespace app {

namespace {

struct InfoArguments {
    std::string dataset;
    bool json = false;
};

void printForPeople(const core::Dataset& dataset) {
    std::printf("%s\n", dataset.name.c_str());
    for (const core::HandModel& hand : dataset.hands) {
        std::printf("  %s hand: %zu vertices, %zu triangles, %zu bones, %d degrees of freedom\n",
                    std::string(core::sideName(hand.side)).c_str(), hand.mesh.vertices.size(),
                    hand.mesh.triangles.size(), hand.skeleton.bones.size(), hand.skeleton.poseSize());
    }
    for (const core::Camera& camera : dataset.cameras) {
        std::printf("  camera %s: %d x %d%s\n", camera.name.c_str(), camera.size.width, camera.size.height,
                    camera.fisheye ? ", fisheye" : "");
    }
    for (const core::Sequence& sequence : dataset.sequences) {
        std::printf("  sequence %s: %d frames, %g per second, %d %s%s\n", sequence.name.c_str(), sequence.frameCount,
                    sequence.framesPerSecond, core::countViews(sequence),
                    core::countViews(sequence) == 1 ? "view" : "views", sequence.motion.empty() ? "" : ", with motion");
    }
}

nlohmann::ordered_json toJson(const core::Dataset& dataset) {
    nlohmann::ordered_json hands = nlohmann::ordered_json::array(), cameras = hands, sequences = hands;
    for (const core::HandModel& hand : dataset.hands) {
        std::vector<std::string> joints;
        for (const core::Bone& bone : hand.skeleton.bones)
            joints.push_back(bone.name);
        hands.push_back({{"side", core::sideName(hand.side)},
                         {"vertices", hand.mesh.vertices.size()},
                         {"triangles", hand.mesh.triangles.size()},
                         {"degreesOfFreedom", hand.skeleton.poseSize()},
                         {"joints", joints}});
    }
    for (const core::Camera& camera : dataset.cameras)
        cameras.push_back({{"name", camera.name}, {"size", {camera.size.width, camera.size.height}}});
    for (const core::Sequence& sequence : dataset.sequences) {
        sequences.push_back({{"name", sequence.name},
                             {"frames", sequence.frameCount},
                             {"framesPerSecond", sequence.framesPerSecond},
                             {"views", core::countViews(sequence)},
                             {"motion", !sequence.motion.empty()}});
    }
    return {{"name", dataset.name}, {"hands", hands}, {"cameras", cameras}, {"sequences", sequences}};
}

} // namespace

void addInfoVerb(CLI::App& program) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App* verb = program.add_subcommand("info", "Say what a dataset holds");
    verb->add_option("dataset", arguments->dataset, "The dataset folder")->required();
    verb->add_flag("--json", arguments->json, "As JSON");
    verb->callback([arguments] {
        const core::Dataset dataset = core::readDataset(arguments->dataset);
        arguments->json ? static_cast<void>(std::fputs(core::formatJson(toJson(dataset)).c_str(), stdout))
                        : printForPeople(dataset);
    });
}

} // namespace app
