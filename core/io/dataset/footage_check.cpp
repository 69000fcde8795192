// SPDX-License-Identifier: MIT
#include "core/io/dataset/footage_check.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/io/dataset/footage_notes.h"
#include "core/io/dataset/footage_presence.h"
#include "core/io/dataset/instants.h"
#include "core/io/dataset/measured_footage.h"
#include "core/io/files/file_pattern.h"
#include "core/io/footage/image_orientation.h"

namespace core {

namespace fs = std::filesystem;

namespace {

void requireFrames(const Sequence& sequence, const ViewSource& view, const MeasuredFootage& video) {
    const int last = footageFrameAt(view, sequence.frameCount - 1);
    if (view.offsetFrames < 0 || last >= video.frames) {
        throw Error(ErrorCode::BadInput, video.path, "frames",
                    "the sequence needs frames " + std::to_string(view.offsetFrames) + " to " + std::to_string(last) +
                        ", the video has " + std::to_string(video.frames));
    }
}

void requireImages(const Sequence& sequence, const ViewSource& view, const std::string& pattern) {
    std::vector<std::string> gone;
    for (int instant = 0; instant < sequence.frameCount; ++instant) {
        const std::string file = fillPattern(pattern, view.camera, footageFrameAt(view, instant));
        if (hasPictureAt(view, instant) && !fs::exists(file))
            gone.push_back(file);
    }
    if (gone.empty())
        return;
    std::string others;
    for (std::size_t i = 1; i < gone.size() && i < 6; ++i)
        others += (i == 1 ? ", nor " : ", ") + fs::path(gone[i]).filename().string();
    if (gone.size() > 6)
        others += " and " + std::to_string(gone.size() - 6) + " more";
    throw Error(ErrorCode::NotFound, gone.front(), "", "no such file" + others);
}

/// The footage of one view. Throws Error if it is not what the sequence needs.
MeasuredFootage measureView(const Dataset& dataset, const Sequence& sequence, const ViewSource& view) {
    const Camera& camera = dataset.cameras[static_cast<std::size_t>(dataset.cameraIndex(view.camera))];
    const std::string path = (dataset.folder / view.path).string();
    MeasuredFootage measured;
    if (view.kind == ViewKind::Video) {
        measured = measureVideo(path, videoIndexFile(dataset.folder, sequence.name, view.camera));
        requireFrames(sequence, view, measured);
    } else {
        requireImages(sequence, view, path);
        measured = measureImages(path, view.camera);
    }
    if (turnedSize(measured.size, view.rotateDegrees) != camera.size)
        throw Error(ErrorCode::BadInput, path, "size", "is not the size that " + camera.name + " is calibrated for");
    return measured;
}

/// Notes that say the same of several views, "cam0: ..." and "cam1: ...", in one: "cam0, cam1: ...", or "all 8 views:
/// ...". The others as they are, all in the order of the first of each.
std::vector<std::string> together(const std::vector<std::string>& notes, const std::vector<ViewSource>& views) {
    std::vector<std::pair<std::string, std::vector<std::string>>> groups; // what is said, and of which cameras
    for (const std::string& note : notes) {
        const auto view = std::find_if(views.begin(), views.end(),
                                       [&note](const ViewSource& one) { return note.starts_with(one.camera + ": "); });
        const std::string text = view == views.end() ? note : note.substr(view->camera.size() + 2);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& one) {
            return one.first == text && one.second.empty() == (view == views.end());
        });
        if (group == groups.end())
            group = groups.insert(groups.end(), {text, {}});
        if (view != views.end())
            group->second.push_back(view->camera);
    }
    std::vector<std::string> joined;
    for (const auto& [text, cameras] : groups) {
        std::string names;
        for (const std::string& camera : cameras)
            names += (names.empty() ? "" : ", ") + camera;
        if (cameras.size() > 2 && cameras.size() == views.size())
            names = "all " + std::to_string(views.size()) + " views";
        joined.push_back(names + (names.empty() ? "" : ": ") + text);
    }
    return joined;
}

} // namespace

std::vector<CheckFinding> checkFootage(const Dataset& dataset, const Sequence& sequence) {
    std::vector<CheckFinding> findings;
    std::map<std::string, MeasuredFootage> measured;
    for (const ViewSource& view : sequence.views) {
        if (view.kind != ViewKind::Video && view.kind != ViewKind::Images)
            continue;
        try {
            measured[view.camera] = measureView(dataset, sequence, view);
        } catch (const Error& error) {
            findings.push_back({false, error.what()});
        }
    }
    std::vector<std::string> notes = notesInWords(sequence);
    for (const FootageNote& found : footageNotes(sequence, measured)) {
        const std::string note = footageNoteText(found);
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) // by its words: old datasets hold text alone
            notes.push_back(note);
    }
    for (const std::string& note : together(notes, sequence.views)) {
        findings.push_back(
            {true, (dataset.folder / "dataset.json").string() + ": sequence \"" + sequence.name + "\": " + note});
    }
    return findings;
}

} // namespace core
