// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/camera_text.h"
#include "app/batch/footage_options.h"
#include "app/batch/option_text.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/calibration/calibration.h"
#include "core/io/dataset/attach_masks.h"
#include "core/io/dataset/new_sequence.h"

namespace app {

namespace {

struct NewArguments {
    std::string cameras, size, hands, sequence, sync, add, out;
    core::CalibrationOptions calibration;
    double mmPerUnit = 0, framesPerSecond = 0;
    int frames = 0; ///< of a sequence without footage
    FootageArguments footage;
    std::vector<std::string> masks;
};

core::CalibrationOptions calibrationOptions(const NewArguments& arguments) {
    core::CalibrationOptions options = arguments.calibration;
    if (!arguments.size.empty())
        options.size = parseImageSize(arguments.size, "--size");
    else if (arguments.footage.scales.empty() && arguments.footage.crops.empty())
        options.size = core::footageSize(footageOf(arguments.footage));
    options.assumeSize = true;
    if (arguments.mmPerUnit > 0)
        options.mmPerUnit = arguments.mmPerUnit;
    return options;
}

core::Dataset emptyDataset(const NewArguments& arguments) {
    core::Dataset dataset;
    dataset.name = std::filesystem::path(arguments.out).filename().string();
    dataset.cameras = core::readCalibration(arguments.cameras, calibrationOptions(arguments));
    if (!arguments.hands.empty()) {
        const core::Dataset other = core::readDataset(arguments.hands);
        dataset.hands = other.hands;
        dataset.handFiles = other.handFiles;
    }
    return dataset;
}

/// The sequence's masks, if any are given; returns notes.
std::vector<std::string> addMasks(core::Dataset& dataset, const NewArguments& arguments) {
    std::vector<core::MaskSource> sources;
    for (const std::string& text : arguments.masks)
        sources.push_back(core::parseMaskSource(dataset, text));
    std::vector<std::string> notes;
    if (!sources.empty())
        for (const core::MaskNote& note : core::attachMasks(dataset, arguments.sequence, sources))
            notes.push_back(core::maskNoteText(note));
    return notes;
}

void print(const std::vector<std::string>& notes) {
    for (const std::string& note : notes)
        std::printf("note: %s\n", note.c_str());
}

core::FootageSync syncOf(const std::string& text) {
    return text == "time"    ? core::FootageSync::Time
           : text == "index" ? core::FootageSync::Index
                             : core::FootageSync::Automatic;
}

void requireOneTarget(const NewArguments& arguments) {
    const bool isNew = arguments.add.empty();
    if (isNew == arguments.out.empty() || isNew == arguments.cameras.empty())
        throw core::Error(core::ErrorCode::Usage, "", "--out", "give either --cameras and --out, or --add");
    if (!isNew && (!arguments.footage.scales.empty() || !arguments.footage.crops.empty())) {
        throw core::Error(
            core::ErrorCode::Usage, "", arguments.footage.scales.empty() ? "--crop" : "--scale",
            "changes the cameras, which all sequences of a dataset share: make a new dataset with --cameras and --out");
    }
}

void makeDataset(const NewArguments& arguments) {
    requireOneTarget(arguments);
    const bool isNew = arguments.add.empty();
    const std::string& folder = isNew ? arguments.out : arguments.add;
    core::Dataset dataset = isNew ? emptyDataset(arguments) : core::readDataset(folder);
    dataset.folder = folder;
    const std::optional<double> rate =
        arguments.framesPerSecond > 0 ? std::optional(arguments.framesPerSecond) : std::nullopt;
    const std::vector<core::Footage> footage = footageOf(arguments.footage);
    const core::NewSequence made =
        footage.empty() && arguments.frames > 0
            ? core::NewSequence{core::sequenceWithoutFootage(arguments.sequence, dataset.cameras, arguments.frames,
                                                             rate),
                                {},
                                dataset.cameras}
            : core::makeSequence(arguments.sequence, dataset.cameras, footage, folder, rate, syncOf(arguments.sync));
    dataset.sequences.push_back(made.sequence);
    dataset.cameras = made.cameras;
    const std::vector<std::string> maskNotes = addMasks(dataset, arguments);
    if (isNew) {
        core::writeDataset(dataset, {}, folder);
        printCameras(dataset.cameras);
        print(core::calibrationNotes(arguments.cameras, calibrationOptions(arguments), dataset.cameras));
    } else {
        core::rewriteDatasetFile(dataset);
    }
    print(core::notesInWords(made.sequence));
    print(maskNotes);
    std::printf("%s: sequence \"%s\" with %d frames, %d of %zu cameras have footage\n", folder.c_str(),
                made.sequence.name.c_str(), made.sequence.frameCount, core::countViews(made.sequence),
                dataset.cameras.size());
}

} // namespace

void addNewVerb(CLI::App& program) {
    auto arguments = std::make_shared<NewArguments>();
    CLI::App* verb = program.add_subcommand("new", "Make a dataset of a calibration and videos or images");
    verb->add_option("--cameras", arguments->cameras, "The calibration, of any kind that `calibration` reads");
    verb->add_option("--from", arguments->calibration.kind, "Its kind, if it does not follow from the content");
    verb->add_option("--size", arguments->size, "Image size WxH, if the calibration holds none");
    verb->add_option("--mm-per-unit", arguments->mmPerUnit, "Length of the calibration's unit in mm")
        ->check(CLI::PositiveNumber);
    verb->add_option("--section", arguments->calibration.section, "Which capture of an InterHand calibration");
    addFootageOptions(*verb, arguments->footage);
    verb->add_option("--masks", arguments->masks,
                     "CAMERA=PATTERN or CAMERA=FOLDER of masks, or a folder or pattern with {camera} for all cameras; "
                     "can be repeated");
    verb->add_option("--fps", arguments->framesPerSecond, "Frames per second, if the footage does not hold them")
        ->check(CLI::PositiveNumber);
    verb->add_option("--sync", arguments->sync,
                     "time: frames are mapped by their time stamps, so that frames which a camera lost are missing in "
                     "its view; index: by their number. "
                     "Default: time where all videos have the same rate and sound time stamps")
        ->check(CLI::IsMember({"index", "time"}));
    verb->add_option("--frames", arguments->frames,
                     "Number of frames of a sequence without footage, for annotations that were made elsewhere")
        ->check(CLI::PositiveNumber);
    verb->add_option("--hands", arguments->hands, "A dataset whose hand models are taken");
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->default_val("1");
    verb->add_option("--add", arguments->add, "Add the sequence to this dataset instead of making a new one");
    verb->add_option("--out", arguments->out, "The dataset folder to create");
    verb->callback([arguments] { makeDataset(*arguments); });
}

} // namespace app
