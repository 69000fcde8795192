// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/io/dataset/new_sequence.h"

namespace app {

/// What the command line says about footage: each text is CAMERA=VALUE.
struct FootageArguments {
    std::vector<std::string> videos, images, offsets, rotations, levels, scales, crops;
};

void addFootageOptions(CLI::App& verb, FootageArguments& arguments);

/// The footage that the texts describe. Throws Error(Usage) naming the option.
std::vector<core::Footage> footageOf(const FootageArguments& arguments);

} // namespace app
