// SPDX-License-Identifier: MIT
#include "widgets/jobs/detector_first_pass.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <thread>

#include "core/annotation/reconstruction.h"
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
    options.otherHands = core::makeDemoHands();
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

/// The frames around a corrected one: those that wait for a look are followed into, up to those that were reviewed.
core::AutoLabels followCorrected(const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                 int frame, std::stop_token stop, MeasuredHands& measured) {
    core::CorrectedFrame corrected{frame, {}};
    for (auto& [id, joint] :
         core::reconstructFrame(set, work.dataset->cameras, frame, rater, {{}, false, std::nullopt}))
        if (joint.hasPoint())
            corrected.joints.emplace(id, *joint.result.point);
    std::set<int> waiting, reviewed;
    for (const auto& [key, mark] : set.marks)
        if (key.rater == rater)
            (mark.isProposal() ? waiting : reviewed).insert(key.frame);
    for (const int one : waiting)
        reviewed.erase(one);
    waiting.insert(frame);
    std::vector<core::HandModel> hands = work.dataset->hands.empty() ? core::makeDemoHands() : work.dataset->hands;
    {
        const std::lock_guard lock(measured.mutex);
        if (measured.dataset == work.dataset->folder && !measured.hands.empty())
            hands = measured.hands;
    }
    core::AutoLabels labels =
        core::retrackFrames(*work.dataset, work.sequence, hands, corrected, {waiting.begin(), waiting.end()},
                            {reviewed.begin(), reviewed.end()}, optionsFor(work), stop);
    labels.erase(frame); // it is the person's
    return labels;
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
    return program;
}

} // namespace widgets
