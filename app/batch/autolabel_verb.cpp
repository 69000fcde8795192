// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include <CLI/CLI.hpp>

#include "app/batch/frame_range.h"
#include "app/batch/interrupt.h"
#include "app/batch/progress.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/detector/auto_label_file.h"
#include "core/io/detector/detector_files.h"
#include "core/io/detector/first_pass.h"
#include "core/io/files/login_name.h"
#include "core/io/store/annotation_store.h"
#include "core/numeric/median.h"
#include "core/simulation/simulated_clicks.h"

namespace app {

namespace {

constexpr double kDoubtful = 0.5; ///< from which on a hand deserves a look

struct AutolabelArguments {
    std::string dataset, sequence, frames, out, rater;
    bool propose = false, landmarksOnly = false, sameHands = false;
    int every = 0;
};

std::string_view sourceName(core::FitSource source) {
    return source == core::FitSource::Landmarks  ? "landmarks"
           : source == core::FitSource::Tracking ? "tracking"
                                                 : "silhouettes";
}

void printHands(const core::FirstPassResult& result) {
    if (result.pass.unitMm != 1)
        std::printf("the calibration's unit is %.4g mm, as the hands tell it\n", result.pass.unitMm);
    if (result.pass.camerasOffPx > 0)
        std::printf(
            "silhouettes lie %.1f px beside the hands: the calibration is off, and the pass adjusted its own copy; "
            "refine it from clicks (rig --refine)\n",
            result.pass.camerasOffPx);
    for (const core::SubjectHand& hand : result.pass.measured)
        std::printf("%s hand: %.3f of the model's size (+-%.3f), %+.1f mm thicker (+-%.1f)\n",
                    std::string(core::sideName(hand.hand.side)).c_str(), hand.scale.value, hand.scale.sigma,
                    hand.girthMm.value, hand.girthMm.sigma);
}

void printLabels(const core::AutoLabels& labels, std::size_t frames) {
    int hands = 0, doubtful = 0, joints = 0, empty = static_cast<int>(frames - labels.size());
    std::vector<double> residualsPx;
    std::map<core::FitSource, int> sources;
    for (const auto& [frame, list] : labels) {
        for (const core::AutoHand& label : list) {
            ++hands;
            ++sources[label.source];
            doubtful += label.doubt >= kDoubtful ? 1 : 0;
            joints += static_cast<int>(label.joints.size());
            for (const core::AutoJoint& joint : label.joints)
                for (const core::AutoView& view : joint.views)
                    if (view.errorPx)
                        residualsPx.push_back(*view.errorPx);
        }
    }
    std::printf("%zu frames, %d hands, %d joints in space\n", frames, hands, joints);
    for (const auto& [source, count] : sources)
        std::printf("%d hands by %s\n", count, std::string(sourceName(source)).c_str());
    if (!residualsPx.empty())
        std::printf("median reprojection error %.2f px\n", core::medianOf(std::move(residualsPx)));
    std::printf("%d hands with a doubt of %.1f or more; %d frames without a hand\n", doubtful, kDoubtful, empty);
}

/// The joints that people click, of the hands of a dataset; all that the detector knows where it has none.
std::vector<core::JointId> clickableJoints(const core::Dataset& dataset) {
    if (!dataset.hands.empty())
        return core::annotatableJoints(dataset.hands);
    std::vector<core::JointId> joints;
    for (const core::Side side : {core::Side::Left, core::Side::Right})
        for (std::size_t i = 0; i < core::kLandmarkCount; ++i)
            joints.push_back({side, std::string(core::landmarkName(i))});
    return joints;
}

void propose(const core::Dataset& dataset, const core::Sequence& sequence, const core::AutoLabels& labels,
             const std::string& rater) {
    auto store = core::AnnotationStore::open(core::annotationFile(dataset, sequence));
    if (store.isReadOnly())
        throw core::Error(core::ErrorCode::Io, store.file().string(), "",
                          "is read-only: " + core::readOnlyText(store.readOnlyReason()));
    const core::Edit edit = core::autoLabelEdit(store.annotations(), dataset, labels, rater, clickableJoints(dataset));
    store.commit(edit, rater);
    std::printf("%zu marks proposed to %s\n", edit.marks.size(), rater.c_str());
}

const char* stageName(core::PassStage stage) {
    switch (stage) {
    case core::PassStage::Detecting:
        return "detecting hands";
    case core::PassStage::Measuring:
        return "measuring the hands";
    case core::PassStage::Fitting:
        return "fitting the hands";
    case core::PassStage::Tracking:
        break;
    }
    return "tracking the hands";
}

core::FirstPassResult pass(const core::Dataset& dataset, const core::Sequence& sequence,
                           const core::DetectorNetworks& networks, const std::vector<int>& frames,
                           const core::FirstPassOptions& options) {
    std::optional<Progress> progress;
    std::optional<core::PassStage> shown;
    core::FirstPassCallbacks callbacks;
    callbacks.progress = [&](core::PassStage stage, int done, int total) {
        if (shown != stage)
            progress.emplace(stageName(stage));
        shown = stage;
        progress->show(done, total);
    };
    const core::FirstPassResult result =
        core::runFirstPass(dataset, sequence, networks, frames, options, interruptToken(), callbacks);
    if (result.resumedFrames > 0)
        std::printf("note: went on with the %d frames of %s\n", result.resumedFrames, options.journal.c_str());
    return result;
}

void autolabel(const AutolabelArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.sequence);
    const std::vector<int> frames = framesOfRange(arguments.frames, sequence.frameCount, "--frames");
    if (core::countViews(sequence) < 2)
        throw core::Error(core::ErrorCode::BadInput, arguments.dataset, "sequence " + sequence.name,
                          "two cameras with pictures are needed");
    const core::DetectorNetworks networks = core::readDetector();
    core::FirstPassOptions options;
    options.journal = arguments.out + ".progress";
    options.otherHands = core::demoHands();
    options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (arguments.every > 0)
        options.keyEveryFrames = arguments.every;
    options.withSilhouettes = !arguments.landmarksOnly;
    options.measureHands = !arguments.sameHands;
    const core::FirstPassResult result = pass(dataset, sequence, networks, frames, options);
    if (!result.isFinished)
        throw Interrupted(arguments.out + ": stopped; what is done is kept in " + options.journal.string() +
                          ", the same command goes on from there");
    core::writeAutoLabels(arguments.out, dataset, sequence, result.labels);
    printHands(result);
    printLabels(result.labels, frames.size());
    if (arguments.propose)
        propose(dataset, sequence, result.labels, arguments.rater);
    core::finishFirstPass(options);
}

} // namespace

void addAutolabelVerb(CLI::App& program) {
    auto arguments = std::make_shared<AutolabelArguments>();
    arguments->rater = core::loginName();
    CLI::App* verb = program.add_subcommand(
        "autolabel", "Find the joints of both hands without a click, each with its covariance and a doubt");
    verb->add_option("dataset", arguments->dataset, "Dataset folder")->required();
    verb->add_option("--sequence", arguments->sequence, "Name of the sequence")->required();
    verb->add_option("--frames", arguments->frames,
                     "Frames A:B:STEP, from A up to B but without it (default: all); parts may be left out");
    verb->add_option("--out", arguments->out, "The ground truth file to write (JSON, rater \"auto\")")->required();
    verb->add_option("--key-every", arguments->every,
                     "The detector looks at frames so far apart, those between are tracked (default: 10)")
        ->check(CLI::Range(1, 1000));
    verb->add_flag("--landmarks-only", arguments->landmarksOnly,
                   "What the detector sees in every frame, without silhouettes: faster, less exact");
    verb->add_flag("--same-hands", arguments->sameHands, "The dataset's hands are the person's: do not measure them");
    verb->add_flag("--propose", arguments->propose,
                   "Put the joints into the sequence's annotations, too, as proposals that a person checks");
    verb->add_option("--rater", arguments->rater, "Whose proposals they are (default: your login name)");
    verb->callback([arguments] { autolabel(*arguments); });
}

} // namespace app
