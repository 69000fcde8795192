// SPDX-License-Identifier: MIT
#include "widgets/jobs/detector_first_pass.h"

#include <algorithm>
#include <thread>

#include "core/annotation/sequence_points.h"
#include "core/io/demo/demo_dataset.h"
#include "core/io/detector/detector_files.h"

namespace widgets {

namespace {

core::FirstPassOptions optionsFor(const FirstPassWork& work) {
    core::FirstPassOptions options;
    options.otherHands = core::makeDemoHands();
    options.journal = work.journal;
    options.threads = static_cast<int>(std::max(2u, std::thread::hardware_concurrency()) - 1);
    return options;
}

FirstPassLabels labelWithDetector(const FirstPassWork& work, std::stop_token stop,
                                  const std::function<void(int, int)>& progress) {
    core::FirstPassCallbacks callbacks;
    callbacks.progress = [&progress](core::PassStage, int done, int total) { progress(done, total); };
    core::FirstPassResult result = core::runFirstPass(*work.dataset, work.sequence, core::readDetector(), work.frames,
                                                      optionsFor(work), stop, callbacks);
    return {std::move(result.labels), result.isFinished};
}

/// The frames of a rater whose proposals wait for a look, and those that hold marks.
void sortFrames(const core::AnnotationSet& set, const std::string& rater, std::vector<int>& waiting,
                std::vector<int>& looked) {
    std::map<int, bool> hasMarks; // by frame; false: proposals alone
    for (const auto& [key, mark] : set.marks)
        if (key.rater == rater)
            hasMarks[key.frame] |= mark.placement != core::Placement::Proposed;
    for (const auto& [frame, marks] : hasMarks)
        (marks ? looked : waiting).push_back(frame);
}

core::AutoLabels followWithModel(const FirstPassWork& work, const core::AnnotationSet& set, const std::string& rater,
                                 int frame, std::stop_token stop) {
    const auto begin = set.marks.lower_bound({frame, "", {}, ""}), end = set.marks.lower_bound({frame + 1, "", {}, ""});
    core::AnnotationSet here;
    here.marks.insert(begin, end);
    core::SequencePoints points = core::sequencePoints(here, work.dataset->cameras, rater);
    std::vector<int> frames, looked;
    sortFrames(set, rater, frames, looked);
    if (!std::binary_search(frames.begin(), frames.end(), frame))
        frames.insert(std::upper_bound(frames.begin(), frames.end(), frame), frame);
    std::erase(looked, frame);
    const core::FirstPassOptions options = optionsFor(work);
    return core::retrackFrames(*work.dataset, work.sequence,
                               work.dataset->hands.empty() ? options.otherHands : work.dataset->hands,
                               {frame, std::move(points[frame])}, frames, looked, options, stop);
}

} // namespace

FirstPassProgram detectorFirstPass() {
    return {[] { return core::isDetectorInstalled(); },
            [](const std::filesystem::path& package) { return core::installDetector(package); }, labelWithDetector,
            followWithModel};
}

} // namespace widgets
