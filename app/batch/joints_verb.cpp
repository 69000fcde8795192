// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/batch/frame_arguments.h"
#include "app/batch/verbs.h"
#include "core/io/files/json_file.h"

namespace app {

namespace {

struct JointsArguments {
    FrameArguments where;
    std::string out;
};

void writeJoints(const JointsArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.where.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.where.sequence);
    requireFrame(sequence, arguments.where.frame, "--frame");
    const core::Motion motion = requireMotion(dataset, sequence);
    nlohmann::ordered_json joints = nlohmann::ordered_json::array();
    for (std::size_t h = 0; h < dataset.hands.size(); ++h) {
        const core::HandModel& hand = dataset.hands[h];
        const auto positions =
            core::jointPositions(hand.skeleton, motion[static_cast<std::size_t>(arguments.where.frame)][h]);
        for (std::size_t b = 0; b < positions.size(); ++b) {
            joints.push_back({{"hand", core::sideName(hand.side)},
                              {"name", hand.skeleton.bones[b].name},
                              {"xyz", core::jsonOf(positions[b])}});
        }
    }
    core::writeJsonFile(
        arguments.out,
        {{"sequence", sequence.name}, {"frame", arguments.where.frame}, {"units", "mm"}, {"joints", joints}});
}

} // namespace

void addJointsVerb(CLI::App& program) {
    auto arguments = std::make_shared<JointsArguments>();
    CLI::App* verb = program.add_subcommand("joints", "Write the recorded 3D joints of a frame");
    addFrameOptions(*verb, arguments->where);
    verb->add_option("--out", arguments->out, "The JSON file to write")->required();
    verb->callback([arguments] { writeJoints(*arguments); });
}

} // namespace app
