// SPDX-License-Identifier: MIT
#include "widgets/jobs/detector_first_pass.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <thread>

#include "core/io/demo/demo_dataset.h"
#include "core/io/detector/detector_files.h"

namespace widgets {

namespace {

/// The person's hands as the last pass measured them: what corrected frames are followed with.
struct MeasuredHands {
    std::mutex mutex;
    std::filesystem::path dataset;
    std::vector<core::HandModel> hands;
};

core::FirstPassOptions optionsFor(const FirstPassWork& work) {
    core::FirstPassOptions options;
    options.journal = work.journal;
    options.otherHands = core::demoHands();
    options.threads = static_cast<int>(std::max(2u, std::thread::hardware_concurrency()) - 1); // one for the window
    return options;
}

FirstPassLabels labelWithDetector(const FirstPassWork& work, std::stop_token stop, const core::PassProgress& progress,
                                  MeasuredHands& measured) {
    core::FirstPassCallbacks callbacks;
    callbacks.progress = progress;
    core::FirstPassResult result = core::runFirstPass(*work.dataset, work.sequence, core::readDetector(), work.frames,
                                                      optionsFor(work), stop, callbacks);
    const std::lock_guard lock(measured.mutex);
    measured.dataset = work.dataset->folder;
    measured.hands = result.pass.hands;
    return {std::move(result.labels), result.isFinished};
}

/// The hands that frames are labelled anew with: measured ones if there are any of this dataset.
std::vector<core::HandModel> handsFor(const core::Dataset& dataset, MeasuredHands& measured) {
    const std::lock_guard lock(measured.mutex);
    if (measured.dataset == dataset.folder && !measured.hands.empty())
        return measured.hands;
    return dataset.hands.empty() ? core::demoHands() : dataset.hands;
}

/// The frames around a corrected one: those that wait for a look are followed into, up to those that were reviewed.
core::AutoLabels followCorrected(const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                 int frame, std::stop_token stop, MeasuredHands& measured) {
    std::set<int> waiting, reviewed;
    for (const auto& [key, mark] : set.marks)
        if (key.rater == rater)
            (mark.isProposal() ? waiting : reviewed).insert(key.frame);
    for (const int one : waiting)
        reviewed.erase(one);
    waiting.insert(frame);
    core::AutoLabels labels = core::retrackFrames(*work.dataset, work.sequence, handsFor(*work.dataset, measured),
                                                  core::correctedFrame(set, work.dataset->cameras, frame, rater),
                                                  {waiting.begin(), waiting.end()}, {reviewed.begin(), reviewed.end()},
                                                  optionsFor(work), stop);
    labels.erase(frame); // it is the person's
    return labels;
}

/// A frame that a person is correcting: what is not placed follows what is.
core::AutoLabels refitCorrected(const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                int frame, std::stop_token stop, MeasuredHands& measured) {
    return core::retrackFrames(*work.dataset, work.sequence, handsFor(*work.dataset, measured),
                               core::correctedFrame(set, work.dataset->cameras, frame, rater), {frame}, {},
                               optionsFor(work), stop);
}

} // namespace

FirstPassProgram detectorFirstPass() {
    const auto measured = std::make_shared<MeasuredHands>();
    FirstPassProgram program;
    program.isInstalled = [] { return core::isDetectorInstalled(); };
    program.install = [](const std::filesystem::path& package) { return core::installDetector(package); };
    program.label = [measured](const FirstPassWork& work, std::stop_token stop, const core::PassProgress& progress) {
        return labelWithDetector(work, stop, progress, *measured);
    };
    program.follow = [measured](const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                int frame, std::stop_token stop) {
        return followCorrected(work, set, rater, frame, stop, *measured);
    };
    program.refit = [measured](const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                               int frame, std::stop_token stop) {
        return refitCorrected(work, set, rater, frame, stop, *measured);
    };
    return program;
}

} // namespace widgets
