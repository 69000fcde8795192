// SPDX-License-Identifier: MIT
#include "core/io/formats/label_videos.h"

#include <algorithm>
#include <filesystem>

#include "core/io/dataset/instants.h"
#include "core/io/files/file_pattern.h"
#include "core/io/formats/format_requests.h"

namespace core {

namespace {

/// What a view's footage is called; empty if it has none.
std::string footageName(const ViewSource& view) {
    const std::filesystem::path path =
        view.kind == ViewKind::Images ? fillPattern(view.path, view.camera, 0) : view.path;
    switch (view.kind) {
    case ViewKind::Video:
        return path.stem().string();
    case ViewKind::Images:
        return path.parent_path().filename().string();
    case ViewKind::None:
    case ViewKind::Rendered:
        break;
    }
    return {};
}

/// The name without the camera's and the signs that joined the two.
std::string without(std::string name, const std::string& camera) {
    constexpr std::string_view kJoints = "_-. ";
    const std::size_t at = name.find(camera);
    const bool isFirst = at == 0;
    name.erase(at, camera.size());
    if (isFirst)
        name.erase(0, std::min(name.find_first_not_of(kJoints), name.size()));
    else if (at == name.size())
        name.erase(name.find_last_not_of(kJoints) + 1);
    return name;
}

/// The camera whose footage has that name, if only one has.
std::optional<std::string> cameraOfFootage(const Sequence& sequence, const std::string& video) {
    std::optional<std::string> camera;
    for (const ViewSource& view : sequence.views)
        if (footageName(view) == video)
            camera = camera ? std::string() : view.camera;
    return camera;
}

} // namespace

std::string videoOfPicture(std::string_view path) {
    const auto isSlash = [](char c) { return c == '/' || c == '\\'; };
    const auto end = std::find_if(path.rbegin(), path.rend(), isSlash);
    if (end == path.rend())
        return {};
    const auto start = std::find_if(end + 1, path.rend(), isSlash);
    return {start.base(), (end + 1).base()};
}

std::optional<VideoOfSequence> videoOfSequence(const Dataset& dataset, const Sequence& sequence,
                                               const std::string& video) {
    if (const auto camera = cameraOfFootage(sequence, video))
        return VideoOfSequence{*camera};
    return videoAskedFor(dataset, sequence, video, {sequence.name});
}

std::optional<VideoOfSequence> videoAskedFor(const Dataset& dataset, const Sequence& sequence, const std::string& video,
                                             const std::vector<std::string>& wanted) {
    const auto isWanted = [&wanted](const std::string& name) {
        return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
    };
    const auto named = cameraIn(dataset, video);
    if (isWanted(video) || (named && isWanted(without(video, *named))))
        return VideoOfSequence{cameraOfFootage(sequence, video).value_or(named.value_or(std::string()))};
    return std::nullopt;
}

namespace {

/// Pictures are numbered as the sequence's frames are: where its footage is numbered otherwise, that has to be said.
void remarkShift(ImportRequest& job, const std::string& camera) {
    for (const ViewSource& view : job.sequence.views) {
        const bool isShifted =
            view.kind == ViewKind::Video && footageFrameAt(view, job.sequence.frameCount) != job.sequence.frameCount;
        if (view.camera == camera && isShifted)
            job.notes.remark(ImportNoteKind::ShiftedFootage, {camera});
    }
}

} // namespace

std::optional<std::string> cameraOfVideo(ImportRequest& job, const std::string& video,
                                         const std::filesystem::path& file) {
    std::optional<VideoOfSequence> found = VideoOfSequence{};
    if (!video.empty()) {
        found = job.options.videos.empty() ? videoOfSequence(job.dataset, job.sequence, video)
                                           : videoAskedFor(job.dataset, job.sequence, video, job.options.videos);
    }
    if (!found) {
        job.notes.leaveOutVideo(video);
        return std::nullopt;
    }
    if (found->camera.empty())
        return cameraOfFile(job, file);
    if (!job.options.camera.empty() && job.options.camera != found->camera) {
        job.notes.leaveOut(ImportNoteKind::OtherCamera, found->camera);
        return std::nullopt;
    }
    remarkShift(job, found->camera);
    return found->camera;
}

} // namespace core
