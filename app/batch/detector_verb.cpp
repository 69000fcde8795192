// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/verbs.h"
#include "core/io/detector/detector_files.h"

namespace app {

namespace {

void installDetector(const std::string& package) {
    const std::string title = core::installDetector(package);
    std::printf("installed the hand detector of %s in %s\n", title.c_str(), core::detectorFolder().c_str());
}

} // namespace

void addDetectorVerb(CLI::App& program) {
    auto package = std::make_shared<std::string>();
    CLI::App* verb = program.add_subcommand("detector", "The hand detector, whose networks are installed separately");
    verb->require_subcommand(1);
    CLI::App* install = verb->add_subcommand(
        "install", "Install the networks of the npm package @mediapipe/hands (get it with: npm pack @mediapipe/hands)");
    install->add_option("package", *package, "The package's .tgz file, or its unpacked folder")->required();
    install->callback([package] { installDetector(*package); });
}

} // namespace app
