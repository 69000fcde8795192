// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/interrupt.h"
#include "app/batch/verbs.h"
#include "core/io/dataset/derived_dataset.h"
#include "core/io/derived/measured_subject.h"

namespace app {

namespace {

struct SubjectArguments {
    std::string dataset, out;
    core::SubjectRequest request;
};

void printBones(const core::SubjectHand& hand) {
    std::printf("  %-12s %-12s %9s %9s %7s %8s\n", "from", "to", "model mm", "mm", "+-", "change");
    for (const core::SubjectBone& bone : hand.bones) {
        std::printf("  %-12s %-12s %9.2f %9.2f %7.2f %+7.2f%%\n", bone.from.c_str(), bone.to.c_str(), bone.modelMm,
                    bone.lengthMm, bone.sigmaMm, 100 * (bone.lengthMm / bone.modelMm - 1));
    }
}

void printNotes(const core::MeasuredSubject& measured) {
    if (measured.unitMm != 1)
        std::printf(
            "note: the calibration is not in mm: its unit is %.4g mm%s; the cameras of the new dataset are in mm\n",
            measured.unitMm,
            measured.isUnitKnown ? ""
                                 : " if this hand is as large as the model: the scale cannot be told from the unit");
    if (measured.annotatedFrames > static_cast<int>(measured.frames.size()))
        std::printf("note: %zu of the %d annotated frames are used, evenly drawn\n", measured.frames.size(),
                    measured.annotatedFrames);
}

void print(const core::MeasuredSubject& measured) {
    const core::SubjectResult& result = measured.result;
    printNotes(measured);
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
                    std::string(core::sideName(measured.dataset.hands[h].side)).c_str(), hand.scale.value,
                    hand.scale.sigma, hand.girthMm.value, hand.girthMm.sigma, hand.frames, hand.jointRmsMm);
        printBones(hand);
    }
}

void writeSubject(const SubjectArguments& arguments) {
    const core::Dataset original = core::readDataset(arguments.dataset);
    const core::MeasuredSubject measured = core::measureSubject(original, arguments.request, {}, interruptToken());
    if (measured.result.stopped)
        throw Interrupted(arguments.out + ": stopped; nothing was written");
    print(measured);
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
    verb->add_option("--out", arguments->out, "The dataset folder to create")->required();
    verb->callback([arguments] { writeSubject(*arguments); });
}

} // namespace app
