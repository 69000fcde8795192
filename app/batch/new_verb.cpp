// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/camera_text.h"
#include "app/batch/option_text.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/calibration.h"
#include "core/io/new_sequence.h"

namespace app {

namespace {

struct NewArguments {
    std::string cameras, size, hands, sequence, add, out;
    core::CalibrationOptions calibration;
    double mmPerUnit = 0, framesPerSecond = 0;
    std::vector<std::string> videos, images, offsets;
};

/// "cam0=path" in two.
std::pair<std::string, std::string> splitAssignment(const std::string& text, const std::string& option) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
        throw core::Error(core::ErrorCode::Usage, "", option, "CAMERA=VALUE is expected, not \"" + text + "\"");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<core::Footage> footageOf(const NewArguments& arguments) {
    std::vector<core::Footage> footage;
    for (const auto& [list, option] : {std::pair(&arguments.videos, "--video"), std::pair(&arguments.images, "--images")}) {
        for (const std::string& text : *list) {
            const auto [camera, path] = splitAssignment(text, option);
            footage.push_back({camera, path, 0});
        }
    }
    for (const std::string& text : arguments.offsets) {
        const auto [camera, frames] = splitAssignment(text, "--offset");
        const auto found = std::find_if(footage.begin(), footage.end(), [&, name = camera](const core::Footage& one) { return one.camera == name; });
        char* end = nullptr;
        const long offset = std::strtol(frames.c_str(), &end, 10);
        if (found == footage.end() || *end != '\0' || offset < 0 || offset > 10'000'000) {
            throw core::Error(core::ErrorCode::Usage, "", "--offset", "\"" + text + "\": a camera with footage and a number of frames from 0 on are expected");
        }
        found->offsetFrames = static_cast<int>(offset);
    }
    return footage;
}

core::Dataset emptyDataset(const NewArguments& arguments) {
    core::CalibrationOptions options = arguments.calibration;
    if (!arguments.size.empty()) {
        options.size = parseImageSize(arguments.size, "--size");
    }
    if (arguments.mmPerUnit > 0) {
        options.mmPerUnit = arguments.mmPerUnit;
    }
    core::Dataset dataset;
    dataset.name = std::filesystem::path(arguments.out).filename().string();
    dataset.cameras = core::readCalibration(arguments.cameras, options);
    if (!arguments.hands.empty()) {
        const core::Dataset other = core::readDataset(arguments.hands);
        dataset.hands = other.hands;
        dataset.handFiles = other.handFiles;
    }
    return dataset;
}

void makeDataset(const NewArguments& arguments) {
    const bool isNew = arguments.add.empty();
    if (isNew == arguments.out.empty() || isNew == arguments.cameras.empty()) {
        throw core::Error(core::ErrorCode::Usage, "", "--out", "give either --cameras and --out, or --add");
    }
    const std::string& folder = isNew ? arguments.out : arguments.add;
    core::Dataset dataset = isNew ? emptyDataset(arguments) : core::readDataset(folder);
    const std::optional<double> rate = arguments.framesPerSecond > 0 ? std::optional(arguments.framesPerSecond) : std::nullopt;
    const core::NewSequence made = core::makeSequence(arguments.sequence, dataset.cameras, footageOf(arguments), folder, rate);
    dataset.sequences.push_back(made.sequence);
    if (isNew) {
        core::writeDataset(dataset, {}, folder);
        printCameras(dataset.cameras);
    } else {
        core::rewriteDatasetFile(dataset);
    }
    for (const std::string& note : made.notes) {
        std::printf("note: %s\n", note.c_str());
    }
    std::printf("%s: sequence \"%s\" with %d frames, %zu cameras\n", folder.c_str(), made.sequence.name.c_str(), made.sequence.frameCount, dataset.cameras.size());
}

} // namespace

void addNewVerb(CLI::App& program) {
    auto arguments = std::make_shared<NewArguments>();
    CLI::App* verb = program.add_subcommand("new", "Make a dataset of a calibration and videos or images");
    verb->add_option("--cameras", arguments->cameras, "The calibration, of any kind that `calibration` reads");
    verb->add_option("--from", arguments->calibration.kind, "Its kind, if the content does not tell");
    verb->add_option("--size", arguments->size, "Image size WxH, if the calibration holds none");
    verb->add_option("--mm-per-unit", arguments->mmPerUnit, "Length of the calibration's unit in mm")->check(CLI::PositiveNumber);
    verb->add_option("--section", arguments->calibration.section, "Which capture of an InterHand calibration");
    verb->add_option("--video", arguments->videos, "CAMERA=FILE; can be repeated");
    verb->add_option("--images", arguments->images, "CAMERA=FOLDER of numbered images, or a pattern such as cam0/{frame:06}.png; can be repeated");
    verb->add_option("--offset", arguments->offsets, "CAMERA=FRAMES: the footage's frame at the sequence's first instant");
    verb->add_option("--fps", arguments->framesPerSecond, "Frames per second, if the footage does not tell")->check(CLI::PositiveNumber);
    verb->add_option("--hands", arguments->hands, "A dataset whose hand models are taken");
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->default_val("1");
    verb->add_option("--add", arguments->add, "Add the sequence to this dataset instead of making a new one");
    verb->add_option("--out", arguments->out, "The dataset folder to create");
    verb->callback([arguments] { makeDataset(*arguments); });
}

} // namespace app
