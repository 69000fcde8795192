// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <set>

#include <CLI/CLI.hpp>

#include "app/batch/camera_text.h"
#include "app/batch/option_text.h"
#include "app/batch/verbs.h"
#include "core/io/calibration/calibration.h"

namespace app {

namespace {

struct CalibrationArguments {
    std::string file, to, out, size;
    core::CalibrationOptions options;
    double scale = 0;
};

void convert(CalibrationArguments arguments) {
    if (!arguments.size.empty())
        arguments.options.size = parseImageSize(arguments.size, "--size");
    arguments.options.assumeSize = true;
    if (arguments.scale > 0)
        arguments.options.mmPerUnit = arguments.scale;
    const std::vector<core::Camera> cameras = core::readCalibration(arguments.file, arguments.options);
    core::writeCalibration(arguments.out, arguments.to, cameras);
    printCameras(cameras);
    for (const std::string& note : core::calibrationNotes(arguments.file, arguments.options, cameras))
        std::printf("note: %s\n", note.c_str());
}

std::set<std::string> kindNames(bool toWrite) {
    std::set<std::string> names;
    for (const core::CalibrationKind& kind : core::calibrationKinds())
        if (kind.canWrite || !toWrite)
            names.emplace(kind.name);
    return names;
}

/// A line for each kind, in the order in which they are tried.
std::string calibrationKindList() {
    std::string text = "Kinds:";
    for (const core::CalibrationKind& kind : core::calibrationKinds()) {
        const std::string name(kind.name);
        text += "\n  " + name + std::string(name.size() < 12 ? 12 - name.size() : 1, ' ') +
                std::string(kind.description) + (kind.canWrite ? "; can be written" : "");
    }
    return text;
}

} // namespace

void addCalibrationVerb(CLI::App& program) {
    auto arguments = std::make_shared<CalibrationArguments>();
    CLI::App* verb = program.add_subcommand("calibration", "Convert a calibration of another program");
    verb->add_option("file", arguments->file, "The file, or the folder for kinds with a file per camera")->required();
    verb->add_option("--from", arguments->options.kind, "Its kind, if it does not follow from the content")
        ->check(CLI::IsMember(kindNames(false)));
    verb->add_option("--to", arguments->to, "The kind to write")->required()->check(CLI::IsMember(kindNames(true)));
    verb->add_option("--size", arguments->size,
                     "Image size WxH, for files that hold none (default: twice the mean principal point, plus one)");
    verb->add_option("--mm-per-unit", arguments->scale, "Length of the file's unit in mm, if it is not the usual one")
        ->check(CLI::PositiveNumber);
    verb->add_option("--section", arguments->options.section, "Which capture of an InterHand file");
    verb->add_option("--out", arguments->out, "The file to write")->required();
    verb->footer(calibrationKindList());
    verb->callback([arguments] { convert(*arguments); });
}

} // namespace app
