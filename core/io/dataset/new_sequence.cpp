// SPDX-License-Identifier: MIT
#include "core/io/dataset/new_sequence.h"

#include <algorithm>
#include <climits>
#include <map>

#include "core/error.h"
#include "core/io/dataset/dataset_paths.h"
#include "core/io/dataset/footage_notes.h"
#include "core/io/dataset/measured_footage.h"
#include "core/io/files/file_pattern.h"
#include "core/io/footage/image_folder.h"
#include "core/io/footage/video_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr double kUsualFramesPerSecond = 50;

/// The footage of one camera on its way into the sequence.
struct Measured : MeasuredFootage {
    int firstFrame = 0;    ///< frame or number at the sequence's first instant
    int rotateDegrees = 0; ///< as decided
    FootageLayout layout{};
};

/// The frame, or the number of the image, that `--offset` names. Images of a folder are counted from its first one; a
/// pattern's offset is the number itself unless that lies before the first.
int namedStart(const Footage& footage, const MeasuredFootage& measured) {
    const int offset = footage.offsetFrames.value_or(0);
    if (measured.kind == ViewKind::Video)
        return offset;
    const bool isNumber =
        footage.path.string().find("{frame") != std::string::npos && offset >= measured.numbers.front();
    const int start = isNumber ? offset : measured.numbers.front() + offset;
    if (start > measured.numbers.back())
        throw Error(ErrorCode::NotFound, fillPattern(measured.path, footage.camera, start), "", "no such file");
    return start;
}

Measured measure(const Footage& footage) {
    Measured measured;
    if (footage.path.string().find("{frame") != std::string::npos)
        static_cast<MeasuredFootage&>(measured) = measureImages(footage.path.string(), footage.camera);
    else if (fs::is_directory(footage.path))
        static_cast<MeasuredFootage&>(measured) = measureImages(findImagePattern(footage.path).pattern, footage.camera);
    else
        static_cast<MeasuredFootage&>(measured) = measureVideo(footage.path);
    measured.firstFrame = namedStart(footage, measured);
    return measured;
}

/// True if the images of these cameras are to be aligned by their first ones: none is missing and all have equally many
/// (they may be numbered from 0 here and from 1 there), or their numbers have nothing in common. Else equal numbers are
/// of the same instant.
bool startTogether(const std::vector<Measured*>& images) {
    const auto hasGap = [](const Measured* one) {
        return one->numbers.back() - one->numbers.front() + 1 != static_cast<int>(one->numbers.size());
    };
    int latestStart = 0, earliestEnd = INT_MAX;
    bool sameCount = true;
    for (const Measured* one : images) {
        latestStart = std::max(latestStart, one->numbers.front());
        earliestEnd = std::min(earliestEnd, one->numbers.back());
        sameCount = sameCount && one->numbers.size() == images.front()->numbers.size();
    }
    return latestStart > earliestEnd || (sameCount && std::none_of(images.begin(), images.end(), hasGap));
}

/// Cameras whose offset is not given start at the same number, or each at its first image.
void alignImages(const std::vector<Footage>& footage, std::map<std::string, Measured>& measured,
                 std::vector<FootageNote>& notes) {
    std::vector<Measured*> images;
    int first = INT_MAX, last = 0;
    FootageNote starts{FootageNoteKind::FirstPicturesDiffer};
    for (const Footage& one : footage) {
        Measured& found = measured[one.camera];
        if (found.kind == ViewKind::Images && !one.offsetFrames) {
            images.push_back(&found);
            first = std::min(first, found.numbers.front());
            last = std::max(last, found.numbers.front());
            starts.cameras.push_back(one.camera);
            starts.numbers.push_back(found.numbers.front());
        }
    }
    if (images.empty() || first == last)
        return;
    if (startTogether(images)) {
        notes.push_back(starts);
        return;
    }
    for (Measured* one : images)
        one->firstFrame = first;
}

void layOutAll(std::map<std::string, Measured>& measured, FootageSync sync) {
    const std::string problem = timeProblem({measured.begin(), measured.end()});
    if (sync == FootageSync::Time && !problem.empty())
        throw Error(ErrorCode::Usage, "", "--sync time", problem);
    for (auto& [camera, one] : measured)
        one.layout = layOut(one, one.firstFrame, sync != FootageSync::Index && problem.empty());
}

/// Black and white points: as asked for, or measured in a few pictures of the sequence.
std::optional<GreyLevels> levelsFor(const Footage& footage, const Measured& measured, int frameCount) {
    if (footage.pictures.levels && measured.kind != ViewKind::Images) {
        throw Error(ErrorCode::Usage, measured.path, "levels",
                    "black and white points are for images, not for a video");
    }
    if (measured.kind != ViewKind::Images || footage.pictures.levels)
        return footage.pictures.levels;
    constexpr int kPictures = 5;
    std::vector<fs::path> files;
    for (int i = 0; i < kPictures; ++i) {
        const int number = measured.firstFrame + i * (frameCount - 1) / (kPictures - 1);
        const auto there = std::lower_bound(measured.numbers.begin(), measured.numbers.end(), number);
        files.push_back(fillPattern(measured.path, footage.camera,
                                    there == measured.numbers.end() ? measured.numbers.back() : *there));
    }
    return measureFileLevels(files);
}

FootageNote levelsNote(const ViewSource& view) {
    const double black = view.levels->black, white = view.levels->white;
    return {FootageNoteKind::Levels, {view.camera}, {}, {black, white}};
}

/// How the pictures of each view are read, and what is to be said about it.
void setPictures(NewSequence& result, const std::vector<Footage>& footage,
                 const std::map<std::string, Measured>& measured) {
    for (const Footage& one : footage) {
        for (ViewSource& view : result.sequence.views) {
            if (view.camera == one.camera) {
                view.rotateDegrees = measured.at(one.camera).rotateDegrees;
                view.levels = levelsFor(one, measured.at(one.camera), result.sequence.frameCount);
                if (view.levels)
                    result.notes.push_back(levelsNote(view));
            }
        }
    }
}

/// Measures all footage and fits it to the cameras.
std::map<std::string, Measured> measureAll(NewSequence& result, const std::vector<Camera>& cameras,
                                           const std::vector<Footage>& footage) {
    std::map<std::string, Measured> measured;
    for (const Footage& one : footage) {
        const auto camera = std::find_if(cameras.begin(), cameras.end(),
                                         [&](const Camera& candidate) { return candidate.name == one.camera; });
        if (camera == cameras.end() || measured.count(one.camera) > 0) {
            throw Error(ErrorCode::Usage, one.path.string(), "camera \"" + one.camera + "\"",
                        "is not a camera of the calibration, or is named twice");
        }
        Measured found = measure(one);
        const PictureSetup setup = setUpPictures(*camera, found.path, found.size, found.orientation, one.pictures);
        result.cameras[static_cast<std::size_t>(camera - cameras.begin())] = setup.camera;
        result.notes.insert(result.notes.end(), setup.notes.begin(), setup.notes.end());
        found.rotateDegrees = setup.rotateDegrees;
        measured[one.camera] = found;
    }
    if (measured.empty())
        throw Error(ErrorCode::Usage, "", "footage", "no video and no images are given");
    return measured;
}

ViewSource viewOf(const Measured& measured, const std::string& camera, int frameCount, const fs::path& datasetFolder) {
    ViewSource view{camera, measured.kind, pathFromDataset(datasetFolder, measured.path), measured.firstFrame};
    view.missing = within(measured.layout.missing, frameCount);
    return view;
}

} // namespace

std::optional<ImageSize> footageSize(const std::vector<Footage>& footage) {
    for (const Footage& one : footage) {
        try {
            const ImageSize size = fs::is_regular_file(one.path) ? readVideoSize(one.path) : measure(one).size;
            const bool isTurned = one.pictures.rotateDegrees.value_or(0) % 180 != 0;
            return isTurned ? ImageSize{size.height, size.width} : size;
        } catch (const Error&) { // what is wrong with it is said when the sequence is made
        }
    }
    return std::nullopt;
}

Sequence sequenceWithoutFootage(const std::string& name, const std::vector<Camera>& cameras, int frameCount,
                                std::optional<double> framesPerSecond) {
    Sequence sequence;
    sequence.name = name;
    sequence.annotations = "annotations/" + name + ".sqlite";
    sequence.frameCount = frameCount;
    sequence.framesPerSecond = framesPerSecond.value_or(kUsualFramesPerSecond);
    for (const Camera& camera : cameras)
        sequence.views.push_back({camera.name, ViewKind::None, "", 0});
    return sequence;
}

NewSequence makeSequence(const std::string& name, const std::vector<Camera>& cameras,
                         const std::vector<Footage>& footage, const fs::path& datasetFolder,
                         std::optional<double> framesPerSecond, FootageSync sync) {
    NewSequence result;
    result.cameras = cameras;
    std::map<std::string, Measured> measured = measureAll(result, cameras, footage);
    alignImages(footage, measured, result.notes);
    layOutAll(measured, sync);
    Sequence& sequence = result.sequence;
    sequence.name = name;
    sequence.annotations = "annotations/" + name + ".sqlite";
    sequence.frameCount = INT_MAX;
    double rate = 0;
    for (const auto& [camera, one] : measured) {
        sequence.frameCount = std::min(sequence.frameCount, one.layout.instants);
        rate = std::max(rate, one.framesPerSecond);
    }
    if (sequence.frameCount < 1) {
        throw Error(ErrorCode::BadInput, measured.begin()->second.path, "frames",
                    "no instant is in the footage of all cameras (check the offsets)");
    }
    sequence.framesPerSecond = framesPerSecond.value_or(rate > 0 ? rate : kUsualFramesPerSecond);
    for (const Camera& camera : cameras) {
        const auto found = measured.find(camera.name);
        sequence.views.push_back(found == measured.end()
                                     ? ViewSource{camera.name, ViewKind::None, "", 0}
                                     : viewOf(found->second, camera.name, sequence.frameCount, datasetFolder));
    }
    setPictures(result, footage, measured);
    for (const FootageNote& note : footageNotes(sequence, {measured.begin(), measured.end()}))
        result.notes.push_back(note);
    sequence.notes = result.notes;
    return result;
}

} // namespace core
