// SPDX-License-Identifier: MIT
#include "core/io/dataset/footage_presence.h"

#include <algorithm>

#include "core/error.h"
#include "core/io/dataset/frames.h"
#include "core/io/dataset/picture_setup.h"
#include "core/io/files/file_pattern.h"
#include "core/io/footage/image_file.h"
#include "core/io/footage/image_orientation.h"
#include "core/io/footage/video_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

fs::path pictureFile(const Dataset& dataset, const ViewSource& view, int instant) {
    return dataset.folder / fillPattern(view.path, view.camera, instant + view.offsetFrames);
}

int missingInstants(const ViewSource& view) {
    int count = 0;
    for (const InstantRange& range : view.missing)
        count += range.count;
    return count;
}

FootageProblem sizeProblem(ImageSize size, const ViewSource& view, const Camera& camera) {
    const ImageSize turned = turnedSize(size, view.rotateDegrees);
    if (turned == camera.size)
        return {};
    return {FootageProblemKind::OtherSize, 0, 0, turned, camera.size, camera.name};
}

FootageProblem videoProblem(const Dataset& dataset, const Sequence& sequence, const ViewSource& view,
                            const Camera& camera) {
    const VideoInfo info = readVideoInfo(dataset.folder / view.path);
    const int needed = view.offsetFrames + sequence.frameCount - missingInstants(view);
    if (info.frames < needed)
        return {FootageProblemKind::TooFewFrames, info.frames, needed};
    return sizeProblem(info.size, view, camera);
}

FootageProblem imagesProblem(const Dataset& dataset, const Sequence& sequence, const ViewSource& view,
                             const Camera& camera) {
    const int needed = sequence.frameCount - missingInstants(view);
    int there = 0;
    fs::path first;
    for (int instant = 0; instant < sequence.frameCount; ++instant) {
        const fs::path file = pictureFile(dataset, view, instant);
        if (fs::exists(file))
            first = there++ == 0 ? file : first;
    }
    if (there < needed)
        return {FootageProblemKind::TooFewPictures, there, needed};
    const cv::Mat image = first.empty() ? cv::Mat() : readImage(first);
    return sizeProblem({image.cols, image.rows}, view, camera);
}

/// As the tag of the video, or of the first picture that exists, says.
Orientation tagOf(const Dataset& dataset, const Sequence& sequence, const ViewSource& view) {
    if (view.kind == ViewKind::Video)
        return {readVideoInfo(dataset.folder / view.path).rotationDegrees, false};
    for (int instant = 0; view.kind == ViewKind::Images && instant < sequence.frameCount; ++instant) {
        const fs::path file = pictureFile(dataset, view, instant);
        if (fs::exists(file))
            return readOrientation(file);
    }
    return {};
}

} // namespace

std::vector<std::string> orientationNotes(const Dataset& dataset, const Sequence& sequence) {
    const std::vector<std::string> known = notesInWords(sequence);
    std::vector<std::string> notes;
    for (const ViewSource& view : sequence.views) {
        try {
            const auto found = orientationNote(view.camera, tagOf(dataset, sequence, view), view.rotateDegrees);
            const std::string note = found ? footageNoteText(*found) : "";
            if (!note.empty() && std::find(known.begin(), known.end(), note) == known.end())
                notes.push_back(note);
        } catch (const Error&) { // said where the footage itself is checked
        }
    }
    return notes;
}

bool hasAnyPicture(const Dataset& dataset, const Sequence& sequence, const ViewSource& view) {
    std::error_code ignored;
    const int instants = view.kind == ViewKind::Video ? 1 : sequence.frameCount;
    for (int instant = 0; instant < instants; ++instant)
        if (fs::exists(view.kind == ViewKind::Video ? dataset.folder / view.path : pictureFile(dataset, view, instant),
                       ignored))
            return true;
    return false;
}

bool hasAnyMask(const Dataset& dataset, const Sequence& sequence, const std::string& camera) {
    std::error_code ignored;
    for (int frame = 0; frame < sequence.frameCount; ++frame) {
        for (const Camera& one : dataset.cameras)
            if ((camera.empty() || camera == one.name) &&
                fs::is_regular_file(maskFile(dataset.folder, sequence, one.name, frame), ignored))
                return true;
    }
    return false;
}

FootageProblem footageProblem(const Dataset& dataset, const Sequence& sequence, const ViewSource& view) {
    const int index = dataset.cameraIndex(view.camera);
    if (index < 0 || (view.kind != ViewKind::Video && view.kind != ViewKind::Images))
        return {};
    const Camera& camera = dataset.cameras[static_cast<std::size_t>(index)];
    try {
        return view.kind == ViewKind::Video ? videoProblem(dataset, sequence, view, camera)
                                            : imagesProblem(dataset, sequence, view, camera);
    } catch (const Error& error) {
        return {FootageProblemKind::Unreadable, 0, 0, {}, {}, camera.name, error.detail()};
    }
}

std::string footageProblemText(const FootageProblem& problem) {
    const std::string needs = ", but the sequence needs " + std::to_string(problem.needed);
    switch (problem.kind) {
    case FootageProblemKind::None:
        break;
    case FootageProblemKind::TooFewFrames:
        return "it has " + std::to_string(problem.count) + " frames" + needs;
    case FootageProblemKind::TooFewPictures:
        return "it has " + std::to_string(problem.count) + " pictures" + needs;
    case FootageProblemKind::OtherSize:
        return "it is " + sizeText(problem.size) + ", but " + problem.camera + " is calibrated for " +
               sizeText(problem.calibrated);
    case FootageProblemKind::Unreadable:
        return problem.detail;
    }
    return "";
}

} // namespace core
