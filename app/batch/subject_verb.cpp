// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/verbs.h"
#include "core/annotation/click_noise.h"
#include "core/annotation/reconstruction.h"
#include "core/annotation/sequence_points.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/dataset/derived_dataset.h"
#include "core/io/dataset/frames.h"
#include "core/subject/subject_estimate.h"

namespace app {

namespace {

/// More frames bring little and cost much: the unknowns of all poses are solved together.
constexpr std::size_t kMostFrames = 15;
/// Hands are never this much smaller or larger than a model: the calibration's unit is another one.
constexpr double kLeastRatio = 0.6, kMostRatio = 1.6;

struct SubjectArguments {
    std::string dataset, rater, out;
    std::vector<std::string> sequences;
    bool withoutMasks = false;
};

struct AnnotatedFrame {
    std::string sequence;
    int frame = 0;
    core::JointPoints points;
};

/// The rater with most joints in 3D.
std::string busiestRater(const core::AnnotationSet& set, const std::vector<core::Camera>& cameras) {
    std::string busiest;
    std::size_t most = 0;
    for (const std::string& rater : core::ratersOf(set)) {
        std::size_t count = 0;
        for (const auto& [frame, points] : core::sequencePoints(set, cameras, rater))
            count += points.size();
        if (count > most) {
            most = count;
            busiest = rater;
        }
    }
    return busiest;
}

/// Everything annotated in the sequences, with covariances of clicks as they scatter.
std::vector<AnnotatedFrame> annotatedFrames(const core::Dataset& dataset, const SubjectArguments& arguments) {
    std::vector<AnnotatedFrame> frames;
    for (const std::string& name : arguments.sequences) {
        const core::AnnotationSet set = core::readAnnotations(dataset, dataset.sequence(name));
        const std::string rater = arguments.rater.empty() ? busiestRater(set, dataset.cameras) : arguments.rater;
        core::TriangulationOptions options;
        if (const auto noise = core::estimateClickNoise(set, dataset.cameras, rater, options))
            options.sigmaPx = std::max(0.2, noise->sigmaPx);
        for (const auto& [frame, points] : core::sequencePoints(set, dataset.cameras, rater, options))
            frames.push_back({name, frame, points});
    }
    return frames;
}

core::SubjectFrame subjectFrame(const core::Dataset& dataset, const AnnotatedFrame& annotated) {
    core::SubjectFrame frame;
    for (const core::HandModel& hand : dataset.hands) {
        auto& targets = frame.targets.emplace_back();
        for (const auto& [id, point] : annotated.points) {
            const int bone = hand.skeleton.boneIndex(id.joint);
            if (id.hand == hand.side && bone >= 0)
                targets.push_back({bone, point.pointInWorld, point.covariance});
        }
    }
    return frame;
}

bool isUseful(const core::SubjectFrame& frame) {
    return std::any_of(
        frame.targets.begin(), frame.targets.end(),
        [](const auto& targets) { return static_cast<int>(targets.size()) >= core::kFewestSubjectJoints; });
}

/// Those that can measure a hand, at most kMostFrames of them, evenly drawn; masks are read for these only.
std::vector<core::SubjectFrame> chosenFrames(const core::Dataset& dataset, std::vector<AnnotatedFrame> useful,
                                             const SubjectArguments& arguments) {
    std::erase_if(useful, [&](const AnnotatedFrame& annotated) { return !isUseful(subjectFrame(dataset, annotated)); });
    const std::size_t count = std::min(useful.size(), kMostFrames);
    if (count < useful.size())
        std::printf("note: %zu of the %zu annotated frames are used, evenly drawn\n", count, useful.size());
    std::vector<core::SubjectFrame> frames;
    for (std::size_t i = 0; i < count; ++i) {
        const AnnotatedFrame& annotated = useful[i * useful.size() / count];
        frames.push_back(subjectFrame(dataset, annotated));
        const core::Sequence& sequence = dataset.sequence(annotated.sequence);
        if (!arguments.withoutMasks && core::hasMasks(sequence)) {
            const auto masks = core::readFrameMasks(dataset.folder, sequence, dataset.cameras, annotated.frame);
            frames.back().outlines = core::makeFitTargets(dataset.cameras, masks, {}, 1);
        }
    }
    return frames;
}

/// Millimetres of the calibration's unit as the hands tell it: 1, 10, 1000 or 25.4, else what makes the hand as large
/// as the model. `ratio` is annotated over model length.
double unitMm(double ratio) {
    if (ratio <= 0 || (ratio > kLeastRatio && ratio < kMostRatio))
        return 1;
    for (const double known : {10.0, 1000.0, 25.4})
        if (ratio * known > 0.75 && ratio * known < 1.33)
            return known;
    return 1 / ratio;
}

/// Brings the cameras to mm if the hands say that they are not, and says so. True if it changed them.
bool makeMetric(core::Dataset& dataset, const std::vector<AnnotatedFrame>& annotatedFrames) {
    std::vector<core::SubjectFrame> frames;
    for (const AnnotatedFrame& annotated : annotatedFrames)
        frames.push_back(subjectFrame(dataset, annotated));
    const double mm = unitMm(core::annotatedOverModelLength(dataset.hands, frames));
    if (mm == 1)
        return false;
    for (core::Camera& camera : dataset.cameras)
        camera.cameraFromWorld.translation *= mm;
    const bool isKnown = mm == 10 || mm == 1000 || mm == 25.4;
    std::printf("note: the calibration is not in mm: its unit is %.4g mm%s; the cameras of the new dataset are in mm\n",
                mm, isKnown ? "" : " if this hand is as large as the model: the scale cannot be told from the unit");
    return true;
}

void printBones(const core::SubjectHand& hand) {
    std::printf("  %-12s %-12s %9s %9s %7s %8s\n", "from", "to", "model mm", "mm", "+-", "change");
    for (const core::SubjectBone& bone : hand.bones) {
        std::printf("  %-12s %-12s %9.2f %9.2f %7.2f %+7.2f%%\n", bone.from.c_str(), bone.to.c_str(), bone.modelMm,
                    bone.lengthMm, bone.sigmaMm, 100 * (bone.lengthMm / bone.modelMm - 1));
    }
}

void print(const core::SubjectResult& result, const core::Dataset& dataset) {
    std::printf("%d annotated frames, outlines of %d\n", result.frames, result.outlineFrames);
    if (result.outlineFrames > 0)
        std::printf("outlines fit to %.2f mm\n", result.outlineSigmaMm);
    else
        std::printf("note: no masks of frames in which all hands are annotated: the girth stays the model's\n");
    if (result.lengthsKept)
        std::printf("note: fewer than 5 frames: the bones keep the model's proportions\n");
    for (std::size_t h = 0; h < result.hands.size(); ++h) {
        const core::SubjectHand& hand = result.hands[h];
        std::printf("%s hand: scale %.4f +- %.4f, girth %+.2f +- %.2f mm, %d frames, joints fit to %.2f mm\n",
                    std::string(core::sideName(dataset.hands[h].side)).c_str(), hand.scale.value, hand.scale.sigma,
                    hand.girthMm.value, hand.girthMm.sigma, hand.frames, hand.jointRmsMm);
        printBones(hand);
    }
}

void measureSubject(const SubjectArguments& arguments) {
    const core::Dataset original = core::readDataset(arguments.dataset);
    if (original.hands.empty())
        throw core::Error(core::ErrorCode::BadInput, arguments.dataset + "/dataset.json", "hands",
                          "there is no hand model to start from");
    core::Dataset changed = original;
    std::vector<AnnotatedFrame> annotated = annotatedFrames(changed, arguments);
    if (makeMetric(changed, annotated))
        annotated = annotatedFrames(changed, arguments);
    const std::vector<core::SubjectFrame> frames = chosenFrames(changed, std::move(annotated), arguments);
    core::SubjectResult result;
    try {
        result = core::estimateSubject(changed.hands, changed.cameras, frames, {}, interruptToken());
    } catch (const core::Error& error) {
        throw core::Error(error.code(), arguments.dataset, error.field(), error.detail());
    }
    if (result.stopped)
        throw Interrupted(arguments.out + ": stopped; nothing was written");
    print(result, changed);
    for (std::size_t h = 0; h < result.hands.size(); ++h)
        changed.hands[h] = result.hands[h].hand;
    core::writeDerivedDataset(original, changed, arguments.out);
    std::printf("%s: the hands of this person\n", arguments.out.c_str());
}

} // namespace

void addSubjectVerb(CLI::App& program) {
    auto arguments = std::make_shared<SubjectArguments>();
    CLI::App* verb = program.add_subcommand(
        "subject", "Measure a person's hands from annotated frames and make a dataset with them");
    verb->add_option("dataset", arguments->dataset, "The dataset folder")->required();
    verb->add_option("--sequence", arguments->sequences, "Names of the annotated sequences, with commas between them")
        ->delimiter(',')
        ->required();
    verb->add_option("--rater", arguments->rater, "Whose marks (those of the one with most joints)");
    verb->add_flag("--without-masks", arguments->withoutMasks, "Joints only: scale and lengths, the model's girth");
    verb->add_option("--out", arguments->out, "The dataset folder to create")->required();
    verb->callback([arguments] { measureSubject(*arguments); });
}

} // namespace app
