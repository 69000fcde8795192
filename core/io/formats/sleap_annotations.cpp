// SPDX-License-Identifier: MIT
#include "core/io/formats/format_requests.h"
#include "core/io/hdf5/sleap_file.h"

// Reads SLEAP's own files. What a person labelled comes as manual marks, what a network guessed as proposals with its
// score; where both are in one place, the person's counts.
namespace core {

namespace {

/// How the marks of one file are placed.
struct Importer {
    ImportRequest& job;
    std::filesystem::path file;
    bool anyGuess = false;

    void add(const SleapInstance& instance) {
        const auto camera = instance.points.empty() ? std::nullopt : cameraOfVideo(job, instance.video, file);
        if (!camera)
            return;
        for (const SleapPoint& point : instance.points)
            addPoint(instance, point, *camera);
    }

private:
    void addPoint(const SleapInstance& instance, const SleapPoint& point, const std::string& camera) {
        const auto joint = jointOfPart(job, point.node, instance.track);
        if (!joint) {
            leaveOutPart(job, point.node);
            return;
        }
        const MarkKey key{instance.frame, job.options.rater, *joint, camera};
        if (instance.isGuess && job.set.marks.contains(key)) {
            job.notes.leaveOut(ImportNoteKind::RepeatedGuesses);
            return;
        }
        anyGuess = anyGuess || instance.isGuess;
        const Placement placement = instance.isGuess ? Placement::Proposed : Placement::Manual;
        addMark(job, instance.frame, *joint, camera, {{point.x, point.y}, placement, MarkState::Visible, point.score});
    }
};

} // namespace

void readSleap(ImportRequest& job) {
    bool anyGuess = false;
    for (const std::filesystem::path& path : viewFiles(job.path, holdsFiles(job.path, ".slp") ? ".slp" : ".h5")) {
        const SleapFile file = readSleapFile(path);
        Importer importer{job, path};
        for (const bool guesses : {false, true})
            for (const SleapInstance& instance : file.instances)
                if (instance.isGuess == guesses)
                    importer.add(instance);
        anyGuess = anyGuess || importer.anyGuess;
        for (int i = 0; i < file.hiddenPoints; ++i)
            job.notes.leaveOut(ImportNoteKind::HiddenLabels);
    }
    if (anyGuess)
        job.notes.remark(ImportNoteKind::SomeGuesses);
}

} // namespace core
