// SPDX-License-Identifier: MIT
#include "core/io/new_sequence.h"

#include <algorithm>
#include <map>

#include "core/error.h"
#include "core/io/dataset_paths.h"
#include "core/io/frames.h"
#include "core/io/image_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// What the footage of one camera holds.
struct Measured {
    ViewKind kind = ViewKind::Video;
    std::string path;  ///< video or pattern, as given
    int firstFrame = 0; ///< of the footage at the sequence's first instant
    int frames = 0;     ///< from there on
    ImageSize size;
    double framesPerSecond = 0; ///< 0 = unknown
    Orientation orientation{};  ///< as the file's tag says
    int rotateDegrees = 0;      ///< as decided
};

bool isImage(const fs::path& file) {
    static const char* const kExtensions[] = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp", ".PNG", ".JPG", ".JPEG"};
    return std::find(std::begin(kExtensions), std::end(kExtensions), file.extension()) != std::end(kExtensions);
}

/// A file name around its last number.
struct NumberedName {
    std::string before, digits, after;
};

NumberedName splitName(const std::string& name) {
    const std::size_t stem = name.rfind('.');
    const std::size_t last = name.find_last_of("0123456789", stem);
    if (last == std::string::npos) {
        return {name, "", ""};
    }
    const std::size_t before = name.find_last_not_of("0123456789", last);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    return {name.substr(0, first), name.substr(first, last - first + 1), name.substr(last + 1)};
}

Measured measureVideo(const Footage& footage) {
    const VideoInfo info = readVideoInfo(footage.path);
    return {ViewKind::Video, footage.path.string(), footage.offsetFrames, info.frames - footage.offsetFrames, info.size, info.framesPerSecond,
            {info.rotationDegrees, false}};
}

Measured measureImages(const Footage& footage, const std::string& pattern, int first) {
    const auto fileAt = [&](int frame) { return fs::path(fillPattern(pattern, footage.camera, frame)); };
    Measured measured{ViewKind::Images, pattern, first + footage.offsetFrames, 0, {}, 0};
    const cv::Mat image = readImage(fileAt(measured.firstFrame)); // throws if there is none
    measured.size = {image.cols, image.rows};
    measured.orientation = readOrientation(fileAt(measured.firstFrame));
    while (fs::exists(fileAt(measured.firstFrame + measured.frames))) {
        ++measured.frames;
    }
    return measured;
}

Measured measure(const Footage& footage) {
    if (footage.path.string().find("{frame") != std::string::npos) {
        // Patterns count from 0 or from 1.
        const bool fromZero = fs::exists(fillPattern(footage.path.string(), footage.camera, footage.offsetFrames));
        return measureImages(footage, footage.path.string(), fromZero ? 0 : 1);
    }
    if (fs::is_directory(footage.path)) {
        const ImagePattern found = findImagePattern(footage.path);
        return measureImages(footage, found.pattern, found.first);
    }
    return measureVideo(footage);
}

/// Black and white points: as asked for, or measured in a few pictures of the sequence.
std::optional<GreyLevels> levelsFor(const Footage& footage, const Measured& measured, int frameCount) {
    if (footage.pictures.levels && measured.kind != ViewKind::Images) {
        throw Error(ErrorCode::Usage, measured.path, "levels", "black and white points are for images, not for a video");
    }
    if (measured.kind != ViewKind::Images || footage.pictures.levels) {
        return footage.pictures.levels;
    }
    constexpr int kPictures = 5;
    std::vector<fs::path> files;
    for (int i = 0; i < kPictures; ++i) {
        files.push_back(fillPattern(measured.path, footage.camera, measured.firstFrame + i * (frameCount - 1) / (kPictures - 1)));
    }
    return measureFileLevels(files);
}

std::string levelsNote(const ViewSource& view) {
    return view.camera + ": its pictures have more than 8 bits; level " + std::to_string(view.levels->black) + " is shown black, " +
           std::to_string(view.levels->white) + " white (--levels " + view.camera + "=BLACK,WHITE)";
}

/// How the pictures of each view are read, and what is to be said about it.
void setPictures(NewSequence& result, const std::vector<Footage>& footage, const std::map<std::string, Measured>& measured) {
    for (const Footage& one : footage) {
        for (ViewSource& view : result.sequence.views) {
            if (view.camera == one.camera) {
                view.rotateDegrees = measured.at(one.camera).rotateDegrees;
                view.levels = levelsFor(one, measured.at(one.camera), result.sequence.frameCount);
                if (view.levels) {
                    result.notes.push_back(levelsNote(view));
                }
            }
        }
    }
}

/// Footage of different length or speed may not be of the same instants.
void noteDifferences(NewSequence& result, const std::map<std::string, Measured>& measured) {
    for (const auto& [camera, footage] : measured) {
        const int more = footage.frames - result.sequence.frameCount;
        if (more > 0) {
            result.notes.push_back(camera + " has " + std::to_string(more) + " frames more than the shortest footage: are they all of the same instants?");
        }
        if (footage.framesPerSecond > 0 && std::abs(footage.framesPerSecond - result.sequence.framesPerSecond) > 0.01 * footage.framesPerSecond) {
            result.notes.push_back(camera + " was recorded at another frame rate than the sequence's " + std::to_string(result.sequence.framesPerSecond));
        }
    }
}

} // namespace

ImagePattern findImagePattern(const fs::path& folder) {
    std::map<int, std::string> names; // by number
    std::optional<NumberedName> common;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (!isImage(entry.path())) {
            continue;
        }
        const NumberedName name = splitName(entry.path().filename().string());
        if (name.digits.empty() || name.digits.size() > 9 || (common && (common->before != name.before || common->after != name.after))) {
            throw Error(ErrorCode::BadInput, entry.path().string(), "", "is not numbered like the other images of its folder");
        }
        common = common.value_or(name);
        names[std::stoi(name.digits)] = name.digits;
    }
    if (!common) {
        throw Error(ErrorCode::BadInput, folder.string(), "", "holds no images");
    }
    const auto isPadded = [](const std::string& digits) { return digits.size() > 1 && digits.front() == '0'; };
    const bool padded = std::any_of(names.begin(), names.end(), [&](const auto& entry) { return isPadded(entry.second); });
    const std::string frame = padded ? "{frame:0" + std::to_string(names.begin()->second.size()) + "}" : "{frame}";
    ImagePattern result{(folder / (common->before + frame + common->after)).string(), names.begin()->first, 0};
    while (names.count(result.first + result.count) > 0) {
        ++result.count;
    }
    return result;
}

NewSequence makeSequence(const std::string& name, const std::vector<Camera>& cameras, const std::vector<Footage>& footage, const fs::path& datasetFolder,
                         std::optional<double> framesPerSecond) {
    NewSequence result;
    result.cameras = cameras;
    std::map<std::string, Measured> measured;
    for (const Footage& one : footage) {
        const auto camera = std::find_if(cameras.begin(), cameras.end(), [&](const Camera& candidate) { return candidate.name == one.camera; });
        if (camera == cameras.end() || measured.count(one.camera) > 0) {
            throw Error(ErrorCode::Usage, one.path.string(), "camera \"" + one.camera + "\"", "is not a camera of the calibration, or is named twice");
        }
        Measured found = measure(one);
        const PictureSetup setup = setUpPictures(*camera, found.path, found.size, found.orientation, one.pictures);
        result.cameras[static_cast<std::size_t>(camera - cameras.begin())] = setup.camera;
        result.notes.insert(result.notes.end(), setup.notes.begin(), setup.notes.end());
        found.rotateDegrees = setup.rotateDegrees;
        measured[one.camera] = found;
    }
    if (measured.empty()) {
        throw Error(ErrorCode::Usage, "", "footage", "no video and no images are given");
    }
    result.sequence.name = name;
    result.sequence.annotations = "annotations/" + name + ".sqlite";
    result.sequence.frameCount = measured.begin()->second.frames;
    double rate = 0;
    for (const auto& [camera, one] : measured) {
        result.sequence.frameCount = std::min(result.sequence.frameCount, one.frames);
        rate = std::max(rate, one.framesPerSecond);
    }
    if (result.sequence.frameCount < 1) {
        throw Error(ErrorCode::BadInput, measured.begin()->second.path, "frames", "no instant is in the footage of all cameras (check the offsets)");
    }
    result.sequence.framesPerSecond = framesPerSecond.value_or(rate > 0 ? rate : 50);
    for (const Camera& camera : cameras) {
        const auto found = measured.find(camera.name);
        const bool has = found != measured.end();
        result.sequence.views.push_back(has ? ViewSource{camera.name, found->second.kind, pathFromDataset(datasetFolder, found->second.path), found->second.firstFrame}
                                            : ViewSource{camera.name, ViewKind::None, "", 0});
    }
    setPictures(result, footage, measured);
    noteDifferences(result, measured);
    result.sequence.notes = result.notes;
    return result;
}

} // namespace core
