// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/io/dataset/attach_masks.h"

namespace app {

namespace {

struct MasksArguments {
    std::string dataset, sequence;
    std::vector<std::string> from;
    int offset = 0;
};

void attach(const MasksArguments& arguments) {
    core::Dataset dataset = core::readDataset(arguments.dataset);
    std::vector<core::MaskSource> sources;
    for (const std::string& text : arguments.from) {
        sources.push_back(core::parseMaskSource(dataset, text));
        sources.back().offset = arguments.offset;
    }
    const std::vector<core::MaskNote> notes = core::attachMasks(dataset, arguments.sequence, sources);
    core::rewriteDatasetFile(dataset);
    for (const core::MaskNote& note : notes)
        std::printf("%s\n", core::maskNoteText(note).c_str());
}

} // namespace

void addMasksVerb(CLI::App& program) {
    auto arguments = std::make_shared<MasksArguments>();
    CLI::App* verb =
        program.add_subcommand("masks", "Give a sequence the masks (silhouettes) that poses are fitted to");
    verb->add_option("dataset", arguments->dataset, "The dataset folder")->required();
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->required();
    verb->add_option("--from", arguments->from,
                     "A folder with <camera>/<number>.png or <camera>_<number>.png, a pattern such as "
                     "masks/{camera}/{frame:06}.png, or "
                     "CAMERA=FOLDER or CAMERA=PATTERN; can be repeated")
        ->required();
    verb->add_option("--offset", arguments->offset, "The number in the masks' names at the sequence's frame 0")
        ->check(CLI::Range(0, 10'000'000));
    verb->callback([arguments] { attach(*arguments); });
}

} // namespace app
