// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/frame_range.h"
#include "app/batch/interrupt.h"
#include "app/batch/progress.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/detector/detector_files.h"
#include "core/io/segmentation/detected_points.h"
#include "core/io/segmentation/mask_record.h"
#include "core/io/segmentation/room_pictures.h"
#include "core/io/segmentation/segment_frames.h"

namespace app {

namespace {

using core::SegmentationMethod;

constexpr int kMedianSamples = 31;

struct SegmentArguments {
    std::string dataset, sequence, frames, how, labels, background, backdrop, out;
    double bandMm = core::SilhouetteOptions().bandMm, forearmPalms = core::kForearmPalms;
    bool attach = false, replace = false;
};

/// "#1fa030" or "1fa030" as BGR.
cv::Scalar parseColour(const std::string& text) {
    const std::string digits = text.substr(text.starts_with("#") ? 1 : 0);
    if (digits.size() != 6 || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
        throw core::Error(core::ErrorCode::Usage, "", "--backdrop", "\"" + text + "\": expected a colour as #rrggbb");
    const unsigned long value = std::stoul(digits, nullptr, 16);
    return {static_cast<double>(value & 255U), static_cast<double>(value >> 8U & 255U),
            static_cast<double>(value >> 16U)};
}

core::SilhouetteOptions optionsOf(const SegmentArguments& arguments) {
    core::SilhouetteOptions options;
    options.method = *core::segmentationMethodFromName(arguments.how);
    options.bandMm = arguments.bandMm;
    options.forearmPalms = arguments.forearmPalms;
    if (!arguments.backdrop.empty())
        options.backdrop = parseColour(arguments.backdrop);
    return options;
}

/// What a run works on.
struct Segmentation {
    const core::Dataset& dataset;
    const core::Sequence& sequence;
    std::vector<int> frames;
    core::SilhouetteOptions options;
};

bool needsHands(SegmentationMethod method) {
    return method == SegmentationMethod::Model || method == SegmentationMethod::Landmarks;
}

/// What is known of the hands' poses already: labels that are given, recorded poses, annotated joints. Empty if nothing
/// is, and the method can do without or landmarks are still to be detected.
core::SequenceEvidence knownEvidence(const Segmentation& run, const SegmentArguments& arguments) {
    const bool byModel = run.options.method == SegmentationMethod::Model;
    const std::string where = "sequence \"" + run.sequence.name + "\"";
    if (byModel && run.dataset.hands.empty())
        throw core::Error(core::ErrorCode::NotFound, arguments.dataset, "hands",
                          "the dataset has no hand models; use --how landmarks");
    const auto& hands = run.dataset.hands;
    core::SequenceEvidence evidence;
    if (!arguments.labels.empty())
        evidence = {hands, core::readLabelPoints(arguments.labels, run.sequence), core::EvidenceOrigin::Labels};
    else if (run.options.method != SegmentationMethod::Landmarks && !run.sequence.motion.empty())
        evidence = {hands, core::readMotion(run.dataset, run.sequence)};
    else
        evidence = {hands, core::readAnnotationPoints(run.dataset, run.sequence), core::EvidenceOrigin::Annotations};
    if (evidence.countKnown(run.frames) > 0)
        return evidence;
    if (!arguments.labels.empty())
        throw core::Error(core::ErrorCode::NotFound, arguments.labels, "frames",
                          "no joint of these frames of " + where + " has a point in space");
    if (byModel)
        throw core::Error(core::ErrorCode::NotFound, arguments.dataset, where,
                          "has neither recorded motion nor annotated joints in these frames; use --labels FILE "
                          "(autolabel writes one) or --how landmarks");
    return {};
}

/// Detects hands where nothing else is known of the joints.
core::SequenceEvidence detected(const Segmentation& run, const core::DetectorNetworks& networks,
                                const SegmentArguments& arguments) {
    Progress progress("detecting hands");
    const auto points = core::detectPoints(run.dataset, run.sequence, networks, run.frames,
                                           std::filesystem::path(arguments.out) / "detections.jsonl", interruptToken(),
                                           [&](int done, int total) { progress.show(done, total); });
    if (!points)
        throw Interrupted(arguments.out + ": stopped; the same command goes on from there");
    return {run.dataset.hands, *points, core::EvidenceOrigin::Detector};
}

/// What segmentation.json says of where the joints or the empty pictures come from.
std::string evidenceName(const Segmentation& run, const core::SequenceEvidence& evidence,
                         const SegmentArguments& arguments) {
    if (run.options.method == SegmentationMethod::Background)
        return arguments.background.empty() ? "median" : "pictures";
    if (run.options.method == SegmentationMethod::Landmarks && evidence.origin() == core::EvidenceOrigin::None)
        return std::string(originName(core::EvidenceOrigin::Detector));
    return std::string(originName(needsHands(run.options.method) ? evidence.origin() : core::EvidenceOrigin::None));
}

void print(const core::SegmentationSummary& summary, const std::string& out) {
    std::printf("%d masks made in %s, %.0f ms each", summary.made, out.c_str(), 1000 * summary.secondsPerMask);
    if (summary.kept > 0)
        std::printf("; %d were there already", summary.kept);
    std::printf("\n");
    if (summary.empty > 0)
        std::printf("note: %d of them are empty: no hand is seen there\n", summary.empty);
    if (summary.unknown > 0)
        std::printf("note: no mask of %d pictures: nothing is known of the hands there\n", summary.unknown);
}

void attach(const SegmentArguments& arguments, const core::SegmentationSummary& summary) {
    if (summary.made + summary.kept == 0)
        throw core::Error(core::ErrorCode::NotFound, arguments.out, "", "no mask was made: nothing is attached");
    for (const std::string& note : core::attachMadeMasks(arguments.dataset, arguments.sequence, arguments.out))
        std::printf("%s\n", note.c_str());
}

void segment(const SegmentArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.sequence);
    const Segmentation run{dataset, sequence, framesOfRange(arguments.frames, sequence.frameCount, "--frames"),
                           optionsOf(arguments)};
    if (core::countViews(sequence) == 0)
        throw core::Error(core::ErrorCode::BadInput, arguments.dataset, "sequence " + sequence.name,
                          "no camera has pictures");
    core::SequenceEvidence evidence = knownEvidence(run, arguments);
    const std::string origin = evidenceName(run, evidence, arguments);
    std::optional<core::DetectorNetworks> networks;
    if (origin == originName(core::EvidenceOrigin::Detector))
        networks = core::readDetector();
    core::SegmentationWork work{&dataset, &sequence, run.frames, run.options, &evidence, {}, arguments.out};
    if (!arguments.background.empty())
        work.roomPictures = core::readRoomPictures(arguments.background, dataset.cameras);
    const std::string others = core::otherMasks(dataset, sequence, arguments.out);
    if (arguments.attach && !arguments.replace && !others.empty())
        throw core::Error(core::ErrorCode::BadInput, arguments.dataset, "masks of sequence " + sequence.name,
                          "it has masks already (" + others + "); use --replace to give it these instead");
    core::claimMaskFolder(arguments.out, core::maskRecord("Handlens " HANDLENS_VERSION, sequence, run.options, origin,
                                                          evidence.origin()));
    if (networks)
        evidence = detected(run, *networks, arguments);
    const core::FrameSource source(dataset, sequence, core::readMotion(dataset, sequence));
    if (origin == "median")
        work.roomPictures = core::medianRoomPictures(source, dataset.cameras.size(), kMedianSamples, interruptToken());
    core::SegmentationSummary summary;
    {
        Progress progress("segmenting");
        summary = core::segmentFrames(work, source, interruptToken(),
                                      [&](int done, int total) { progress.show(done, total); });
    }
    if (summary.stopped)
        throw Interrupted(arguments.out + ": stopped; " + std::to_string(summary.made + summary.kept) +
                          " masks are whole, the same command goes on from there");
    print(summary, arguments.out);
    if (arguments.attach)
        attach(arguments, summary);
}

void addOptions(CLI::App& verb, SegmentArguments& arguments) {
    verb.add_option("dataset", arguments.dataset, "Dataset folder")->required();
    verb.add_option("--sequence", arguments.sequence, "Name of the sequence")->required();
    verb.add_option("--frames", arguments.frames,
                    "Frames A:B:STEP, from A up to B but without it (default: all); parts may be left out");
    std::vector<std::string> methods;
    for (const SegmentationMethod method : core::kSegmentationMethods)
        methods.emplace_back(methodName(method));
    verb.add_option("--how", arguments.how,
                    "landmarks: by the hands' joints, annotated or detected; model: by the posed hand model; "
                    "background: what differs from the empty room; chroma: what has not the backdrop's colour; skin: "
                    "what has the colour of skin")
        ->required()
        ->check(CLI::IsMember(methods));
    verb.add_option("--labels", arguments.labels,
                    "Ground truth JSON with the joints (as autolabel writes it), for landmarks and model; the others "
                    "end forearms by them");
    verb.add_option("--band", arguments.bandMm, "By how many mm the model's pose may be wrong (model)")
        ->check(CLI::Range(0.0, 50.0))
        ->capture_default_str();
    verb.add_option("--forearm", arguments.forearmPalms,
                    "How much of the forearm is kept, in lengths of the palm from the wrist (all but model, where "
                    "joints are known)")
        ->check(CLI::Range(0.0, core::kForearmPalms))
        ->capture_default_str();
    verb.add_option("--background", arguments.background,
                    "Folder with <camera>.png or .jpg of the empty room (background; default: the video's median)");
    verb.add_option("--backdrop", arguments.backdrop,
                    "The backdrop's colour #rrggbb (chroma; default: that of the picture's border)");
    verb.add_option("--out", arguments.out, "The folder for <camera>/<frame>.png and segmentation.json")->required();
    verb.add_flag("--attach", arguments.attach, "Give the sequence these masks in dataset.json");
    verb.add_flag("--replace", arguments.replace, "With --attach: instead of the masks that it has");
}

} // namespace

void addSegmentVerb(CLI::App& program) {
    auto arguments = std::make_shared<SegmentArguments>();
    CLI::App* verb = program.add_subcommand("segment", "Make the masks (silhouettes of the hands) from the pictures");
    addOptions(*verb, *arguments);
    verb->callback([arguments] { segment(*arguments); });
}

} // namespace app
