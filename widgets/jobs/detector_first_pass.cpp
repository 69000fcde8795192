// SPDX-License-Identifier: MIT
#include "widgets/jobs/detector_first_pass.h"

#include "core/io/detector/detector_files.h"

namespace widgets {

namespace {

FirstPassLabels labelWithDetector(const FirstPassWork& work, std::stop_token stop,
                                   const std::function<void(int, int)>& progress) {
    const core::DetectorNetworks networks = core::readDetector();
    core::DetectionJournal journal(work.journal, core::firstPassWork(*work.dataset, work.sequence, networks),
                                   work.dataset->cameras.size());
    const bool isFinished =
        core::detectFrames(*work.dataset, work.sequence, networks, work.frames, journal, stop, progress);
    return {core::labelsOf(*work.dataset, work.sequence, journal.frames(), work.frames), isFinished};
}

} // namespace

FirstPassProgram detectorFirstPass() {
    return {[] { return core::isDetectorInstalled(); },
            [](const std::filesystem::path& package) { return core::installDetector(package); },
            labelWithDetector,
            {}};
}

} // namespace widgets
