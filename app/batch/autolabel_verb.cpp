// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/batch/frame_range.h"
#include "app/batch/interrupt.h"
#include "app/batch/progress.h"
#include "app/batch/verbs.h"
#include "core/error.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/detector/auto_label_file.h"
#include "core/io/detector/detector_files.h"
#include "core/io/files/login_name.h"
#include "core/io/store/annotation_store.h"
#include "core/numeric/median.h"

namespace app {

namespace {

constexpr double kDoubtful = 0.5; ///< from which on a hand deserves a look

struct AutolabelArguments {
    std::string dataset, sequence, frames, out, rater;
    bool propose = false;
};

void printLabels(const core::AutoLabels& labels, std::size_t frames) {
    int hands = 0, doubtful = 0, joints = 0, empty = static_cast<int>(frames - labels.size());
    std::vector<double> residualsPx;
    for (const auto& [frame, list] : labels) {
        empty += list.empty() ? 1 : 0;
        for (const core::AutoHand& label : list) {
            ++hands;
            doubtful += label.doubt >= kDoubtful ? 1 : 0;
            for (const auto& landmark : label.hand.hand.landmarks) {
                if (!landmark)
                    continue;
                ++joints;
                for (std::size_t i = 0; i < landmark->cameras.size(); ++i)
                    if (landmark->triangulated.inlier[i])
                        residualsPx.push_back(landmark->triangulated.residualPx[i]);
            }
        }
    }
    std::printf("%zu frames, %d hands, %d joints in space\n", frames, hands, joints);
    if (!residualsPx.empty())
        std::printf("median reprojection error %.2f px\n", core::medianOf(std::move(residualsPx)));
    std::printf("%d hands with a doubt of %.1f or more; %d frames without a hand\n", doubtful, kDoubtful, empty);
}

void propose(const core::Dataset& dataset, const core::Sequence& sequence, const core::AutoLabels& labels,
             const std::string& rater) {
    auto store = core::AnnotationStore::open(core::annotationFile(dataset, sequence));
    if (store.isReadOnly())
        throw core::Error(core::ErrorCode::Io, store.file().string(), "",
                          "is read-only: " + core::readOnlyText(store.readOnlyReason()));
    const core::Edit edit = core::autoLabelEdit(store.annotations(), dataset, labels, rater);
    store.commit(edit, rater);
    std::printf("%zu marks proposed to %s\n", edit.marks.size(), rater.c_str());
}

void autolabel(const AutolabelArguments& arguments) {
    const core::Dataset dataset = core::readDataset(arguments.dataset);
    const core::Sequence& sequence = dataset.sequence(arguments.sequence);
    const std::vector<int> frames = framesOfRange(arguments.frames, sequence.frameCount, "--frames");
    if (core::countViews(sequence) < 2)
        throw core::Error(core::ErrorCode::BadInput, arguments.dataset, "sequence " + sequence.name,
                          "two cameras with pictures are needed");
    const core::DetectorNetworks networks = core::readDetector();
    const std::string journalFile = arguments.out + ".progress";
    core::DetectionJournal journal(journalFile, core::firstPassWork(dataset, sequence, networks),
                                   dataset.cameras.size());
    if (!journal.frames().empty())
        std::printf("note: goes on with the %zu frames of %s\n", journal.frames().size(), journalFile.c_str());
    bool finished = false;
    {
        Progress progress("detecting hands");
        finished = core::detectFrames(dataset, sequence, networks, frames, journal, interruptToken(),
                                      [&](int done, int total) { progress.show(done, total); });
    }
    if (!finished)
        throw Interrupted(arguments.out + ": stopped; " + std::to_string(journal.frames().size()) +
                          " frames are kept in " + journalFile + ", the same command goes on from there");
    const core::AutoLabels labels = core::labelsOf(dataset, sequence, journal.frames(), frames);
    core::writeAutoLabels(arguments.out, dataset, sequence, labels);
    printLabels(labels, frames.size());
    if (arguments.propose)
        propose(dataset, sequence, labels, arguments.rater);
    journal.remove();
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
    verb->add_flag("--propose", arguments->propose,
                   "Put the joints into the sequence's annotations, too, as proposals that a person checks");
    verb->add_option("--rater", arguments->rater, "Whose proposals they are (default: your login name)");
    verb->callback([arguments] { autolabel(*arguments); });
}

} // namespace app
