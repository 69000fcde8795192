// SPDX-License-Identifier: MIT
#include "app/batch/frame_arguments.h"

#include <CLI/CLI.hpp>

#include "core/error.h"

namespace app {

void addFrameOptions(CLI::App& verb, FrameArguments& arguments) {
    verb.add_option("dataset", arguments.dataset, "The dataset folder")->required();
    verb.add_option("--sequence", arguments.sequence, "Name of the sequence")->required();
    verb.add_option("--frame", arguments.frame, "Frame, from 0")->required();
}

void requireFrame(const core::Sequence& sequence, int frame, const std::string& option) {
    if (frame < 0 || frame >= sequence.frameCount) {
        throw core::Error(core::ErrorCode::NotFound, "", option,
                          "sequence \"" + sequence.name + "\" has frames 0 to " +
                              std::to_string(sequence.frameCount - 1) + ", not " + std::to_string(frame));
    }
}

core::Motion requireMotion(const core::Dataset& dataset, const core::Sequence& sequence) {
    core::Motion motion = core::readMotion(dataset, sequence);
    if (motion.empty()) {
        throw core::Error(core::ErrorCode::NotFound, dataset.folder.string(), "sequence \"" + sequence.name + "\"",
                          "has no recorded motion");
    }
    return motion;
}

} // namespace app
