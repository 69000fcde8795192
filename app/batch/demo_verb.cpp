// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/io/demo/demo_dataset.h"

namespace app {

namespace {

void writeDemo(const std::string& out) {
    const core::NewDataset demo = core::makeDemoDataset();
    core::writeDataset(demo.dataset, demo.motions, out);
    std::printf("%s: %zu hands, %zu sequences, %zu cameras\n", out.c_str(), demo.dataset.hands.size(),
                demo.dataset.sequences.size(), demo.dataset.cameras.size());
}

} // namespace

void addDemoVerb(CLI::App& program) {
    auto out = std::make_shared<std::string>();
    CLI::App* verb =
        program.add_subcommand("demo", "Write the demo dataset: two hands, four choreographies, eight views");
    verb->add_option("--out", *out, "The dataset folder to create")->required();
    verb->callback([out] { writeDemo(*out); });
}

} // namespace app
