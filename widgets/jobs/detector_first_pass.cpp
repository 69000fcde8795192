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

/// The person's hands as the last pass measured them, and the cameras as it adjusted them: what corrected frames are
/// followed with.
struct Measured {
    std::vector<core::HandModel> hands;
    std::vector<core::Camera> cameras;
};
struct MeasuredHands {
    std::mutex mutex;
    std::filesystem::path folder;
    std::weak_ptr<const core::Dataset> dataset; ///< another one of the same folder may have another calibration
    Measured last;
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
    measured.folder = work.dataset->folder;
    measured.dataset = work.dataset;
    measured.last = {result.pass.hands, result.pass.cameras};
    return {std::move(result.labels), result.isFinished, result.pass.camerasOffPx};
}

/// What frames are labelled anew with: what was measured, if anything was of this dataset.
Measured measuredFor(const FirstPassWork& work, MeasuredHands& measured) {
    const core::Dataset& dataset = *work.dataset;
    const std::lock_guard lock(measured.mutex);
    if (measured.folder != dataset.folder || measured.last.hands.empty())
        return {dataset.hands.empty() ? core::demoHands() : dataset.hands, dataset.cameras};
    return {measured.last.hands, measured.dataset.lock() == work.dataset ? measured.last.cameras : dataset.cameras};
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
    const Measured with = measuredFor(work, measured);
    core::AutoLabels labels = core::retrackFrames(
        *work.dataset, work.sequence, with.hands, with.cameras,
        core::correctedFrame(set, work.dataset->cameras, frame, rater, with.cameras), {waiting.begin(), waiting.end()},
        {reviewed.begin(), reviewed.end()}, optionsFor(work), stop);
    labels.erase(frame); // it is the person's
    return labels;
}

/// A frame that a person is correcting: what is not placed follows what is.
core::AutoLabels refitCorrected(const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                int frame, std::stop_token stop, MeasuredHands& measured) {
    const Measured with = measuredFor(work, measured);
    return core::retrackFrames(*work.dataset, work.sequence, with.hands, with.cameras,
                               core::correctedFrame(set, work.dataset->cameras, frame, rater, with.cameras), {frame},
                               {}, optionsFor(work), stop);
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
