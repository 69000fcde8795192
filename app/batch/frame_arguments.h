// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/hand/hand_model.h"
#include "core/io/dataset/dataset.h"

namespace CLI {
class App;
}

namespace app {

/// The options that name one frame of a sequence.
struct FrameArguments {
    std::string dataset;
    std::string sequence;
    int frame = 0;
};

/// DATASET --sequence S --frame F
void addFrameOptions(CLI::App& verb, FrameArguments& arguments);

/// Throws Error(NotFound) naming the sequence and how many frames it has.
void requireFrame(const core::Sequence& sequence, int frame, const std::string& option);

/// The recorded motion of a sequence. Throws Error(NotFound) if it has none.
core::Motion requireMotion(const core::Dataset& dataset, const core::Sequence& sequence);

} // namespace app
