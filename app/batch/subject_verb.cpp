// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/verbs.h"
#include "core/io/dataset/dataset_rig.h"
#include "core/io/dataset/derived_dataset.h"
#include "core/io/derived/measured_subject.h"
#include "core/io/derived/subject_file.h"
#include "core/rig/rig_findings.h"

namespace app {

namespace {

struct SubjectArguments {
    std::string dataset, json, out;
    core::SubjectRequest request;
};

void printBones(const core::SubjectHand& hand) {
    std::printf("  %-12s %-12s %9s %9s %7s %8s\n", "from", "to", "model mm", "mm", "+-", "change");
    for (const core::SubjectBone& bone : hand.bones) {
        std::printf("  %-12s %-12s %9.2f %9.2f %7.2f %+7.2f%%\n", bone.from.c_str(), bone.to.c_str(), bone.modelMm,
                    bone.lengthMm, bone.sigmaMm, 100 * (bone.lengthMm / bone.modelMm - 1));
    }
}

void printCalibration(const core::MeasuredSubject& measured) {
    if (measured.unitMm != 1)
        std::printf(
            "note: the calibration is not in mm: its unit is %.4g mm%s; the cameras of the new dataset are in mm\n",
            measured.unitMm,
            measured.isUnitKnown ? ""
                                 : " if this hand is as large as the model: the scale cannot be told from the unit");
    for (const std::string& finding : core::rigFindings(measured.rigHealth, core::sequenceNames(measured.dataset)))
        std::printf("warning: %s\n", finding.c_str());
    const std::vector<core::RigFinding> faults = core::findRigFaults(measured.rigHealth);
    if (std::any_of(faults.begin(), faults.end(), [](const auto& fault) { return core::isOffFinding(fault.kind); }))
        std::printf(
            "warning: lengths and girth cannot be better than the calibration: refine it first (rig --refine)\n");
}

void printFrames(const core::MeasuredSubject& measured) {
    const core::SubjectResult& result = measured.result;
    if (measured.annotatedFrames > static_cast<int>(measured.frames.size()))
        std::printf("note: %zu of the %d annotated frames are used, evenly drawn\n", measured.frames.size(),
                    measured.annotatedFrames);
    std::printf("%d annotated frames, outlines of %d\n", result.frames, result.outlineFrames);
    if (result.girthKept)
        std::printf("note: fewer than 3 frames: only the scale is measured\n");
    else if (result.outlineFrames == 0)
        std::printf("note: no masks of frames in which all hands are annotated: the girth stays the model's\n");
    else
        std::printf("outlines fit to %.2f mm\n", result.outlineSigmaMm);
    if (result.lengthsKept && !result.girthKept)
        std::printf("note: fewer than 5 frames: the bones keep the model's proportions\n");
    constexpr double kNoticeableMm = 0.1;
    if (result.modelSigmaMm >= kNoticeableMm)
        std::printf("joints are clicked %.2f mm (per axis) beside those of the model\n", result.modelSigmaMm);
}

void printHand(const core::SubjectHand& hand, bool hasGirth) {
    const std::string side(core::sideName(hand.hand.side));
    std::printf("%s hand: scale %.4f +- %.4f, ", side.c_str(), hand.scale.value, hand.scale.sigma);
    if (hasGirth)
        std::printf("girth %+.2f +- %.2f mm, ", hand.girthMm.value, hand.girthMm.sigma);
    if (hand.frames > 0)
        std::printf("%d frames, joints fit to %.2f mm\n", hand.frames, hand.jointRmsMm);
    else
        std::printf("annotated in no frame: it follows the other hand\n");
    printBones(hand);
    for (const core::SubjectBone& bone : hand.bones)
        if (bone.isUnlikeModel())
            std::printf("note: %s %s - %s is %.1f %% (+- %.1f) %s than the rest of the hand lets expect\n",
                        side.c_str(), bone.from.c_str(), bone.to.c_str(), std::abs(100 * bone.share),
                        100 * bone.shareSigma, bone.share > 0 ? "longer" : "shorter");
}

void print(const core::MeasuredSubject& measured) {
    printCalibration(measured);
    printFrames(measured);
    for (const core::SubjectHand& hand : measured.result.hands)
        printHand(hand, measured.result.outlineFrames > 0);
}

void writeSubject(const SubjectArguments& arguments) {
    const core::Dataset original = core::readDataset(arguments.dataset);
    const core::MeasuredSubject measured = core::measureSubject(original, arguments.request, {}, interruptToken());
    if (measured.result.stopped)
        throw Interrupted(arguments.out + ": stopped; nothing was written");
    print(measured);
    if (!arguments.json.empty())
        core::writeSubjectFile(arguments.json, measured);
    core::writeDerivedDataset(original, measured.dataset, arguments.out);
    std::printf("%s: the hands of this person\n", arguments.out.c_str());
}

} // namespace

void addSubjectVerb(CLI::App& program) {
    auto arguments = std::make_shared<SubjectArguments>();
    CLI::App* verb = program.add_subcommand(
        "subject", "Measure a person's hands from annotated frames and make a dataset with them");
    verb->add_option("dataset", arguments->dataset, "The dataset folder")->required();
    verb->add_option("--sequence", arguments->request.sequences,
                     "Names of the annotated sequences, with commas between them")
        ->delimiter(',')
        ->required();
    verb->add_option("--rater", arguments->request.rater, "Whose marks (those of the one with most joints)");
    verb->add_flag("--without-masks", arguments->request.withoutMasks,
                   "Joints only: scale and lengths, the model's girth");
    verb->add_option("--most-frames", arguments->request.mostFrames,
                     "At most so many annotated frames, evenly drawn from all")
        ->check(CLI::Range(1, 200))
        ->capture_default_str();
    verb->add_option("--json", arguments->json, "Write the measurement as JSON");
    verb->add_option("--out", arguments->out, "The dataset folder to create")->required();
    verb->callback([arguments] { writeSubject(*arguments); });
}

} // namespace app
