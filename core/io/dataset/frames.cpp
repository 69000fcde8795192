// SPDX-License-Identifier: MIT
#include "core/io/dataset/frames.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>

#include <opencv2/core.hpp>

#include "core/contour/shaded_image.h"
#include "core/error.h"
#include "core/io/dataset/instants.h"
#include "core/io/dataset/measured_footage.h"
#include "core/io/files/file_pattern.h"
#include "core/io/footage/grey_levels.h"
#include "core/io/footage/image_file.h"
#include "core/io/footage/video_file.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// The hands posed for one frame, shared by the views of that frame.
struct PosedHands {
    int frame = -1;
    std::vector<std::vector<Eigen::Vector3d>> vertices, normals; ///< per hand, world
};

/// The view of one camera; a video is opened at its first frame.
struct View {
    ViewSource source;
    std::mutex mutex; ///< guards what follows
    std::unique_ptr<VideoFile> video;
    std::int64_t budget = 0;                 ///< that the video has
    std::optional<GreyLevels> guessedLevels; ///< by the first picture, where the dataset says none
};

/// Turned clockwise by a multiple of 90 degrees.
cv::Mat turned(const cv::Mat& picture, int degrees) {
    if (degrees == 0 || picture.empty())
        return picture;
    cv::Mat result;
    cv::rotate(picture, result,
               degrees == 90    ? cv::ROTATE_90_CLOCKWISE
               : degrees == 180 ? cv::ROTATE_180
                                : cv::ROTATE_90_COUNTERCLOCKWISE);
    return result;
}

/// Whether that is the size of the camera's pictures, or of them shrunk.
bool isSizeOf(const cv::Mat& picture, ImageSize size, int shrink) {
    const auto is = [&](int divisor) {
        return picture.cols == (size.width + divisor - 1) / divisor &&
               picture.rows == (size.height + divisor - 1) / divisor;
    };
    return is(1) || is(shrink);
}

} // namespace

struct FrameSource::Impl {
    fs::path folder;
    std::string sequenceName;
    int frameCount = 0;
    std::vector<Camera> cameras;
    std::vector<HandModel> hands;
    Motion motion;
    std::vector<std::unique_ptr<View>> views; ///< parallel to cameras
    std::atomic<int> firstCamera = -1;
    std::atomic<std::int64_t> budget = 0; ///< bytes for decoded pictures of all videos; 0: a few pictures each
    std::mutex posedMutex;
    std::shared_ptr<const PosedHands> posed; ///< of the frame that was rendered last

    std::shared_ptr<const PosedHands> posedAt(int frame);
    cv::Mat rendered(const Camera& camera, int frame);
    cv::Mat fromVideo(View& view, int frame, const std::stop_token& stop, int shrink);
    cv::Mat smallAsShown(int camera, const cv::Mat& picture) const;
    void applyBudget(View& view) const;
    int videoCount() const;
    int threadsFor(const View& view) const;
    cv::Mat fromImage(View& view, int frame) const;
    GreyLevels levelsOf(View& view, const cv::Mat& picture) const;
};

std::shared_ptr<const PosedHands> FrameSource::Impl::posedAt(int frame) {
    const std::lock_guard lock(posedMutex);
    if (!posed || posed->frame != frame) {
        auto next = std::make_shared<PosedHands>();
        next->frame = frame;
        for (std::size_t h = 0; h < hands.size(); ++h) {
            next->vertices.push_back(posedVertices(hands[h], motion[static_cast<std::size_t>(frame)][h]));
            next->normals.push_back(vertexNormals(next->vertices.back(), hands[h].mesh.triangles));
        }
        posed = std::move(next);
    }
    return posed;
}

cv::Mat FrameSource::Impl::rendered(const Camera& camera, int frame) {
    const std::shared_ptr<const PosedHands> shared = posedAt(frame);
    std::vector<ShadedSurface> surfaces;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        surfaces.push_back(
            {{&shared->vertices[h], &hands[h].mesh.triangles}, &shared->normals[h], skinColour(hands[h].side)});
    }
    return renderShaded(camera, surfaces);
}

int FrameSource::Impl::videoCount() const {
    return static_cast<int>(std::count_if(
        views.begin(), views.end(), [](const auto& view) { return view->source.kind == ViewKind::Video; }));
}

/// Several videos are decoded side by side, so each takes only some of the cores; the one that is wanted first may have
/// them all.
int FrameSource::Impl::threadsFor(const View& view) const {
    const int first = firstCamera, cores = static_cast<int>(std::thread::hardware_concurrency());
    const bool isFirst =
        first >= 0 && first < static_cast<int>(views.size()) && views[static_cast<std::size_t>(first)].get() == &view;
    return std::clamp(isFirst ? cores : cores / std::max(1, videoCount()), 1, 4);
}

/// A small picture of a video, turned; empty if it is not of the camera's size.
cv::Mat FrameSource::Impl::smallAsShown(int camera, const cv::Mat& picture) const {
    const auto at = static_cast<std::size_t>(camera);
    const cv::Mat shown = turned(picture, views[at]->source.rotateDegrees);
    return isSizeOf(shown, cameras[at].size, kGlanceShrink) ? shown : cv::Mat();
}

/// Where it is next used, so that a change of the budget does not wait for a video.
void FrameSource::Impl::applyBudget(View& view) const {
    const std::int64_t share = budget / std::max(1, videoCount());
    if (share > 0 && share != view.budget)
        view.video->setBudget(view.budget = share);
}

cv::Mat FrameSource::Impl::fromVideo(View& view, int frame, const std::stop_token& stop, int shrink) {
    const std::lock_guard lock(view.mutex);
    if (stop.stop_requested())
        return {};
    if (!view.video) {
        const fs::path index = videoIndexFile(folder, sequenceName, view.source.camera);
        view.video = std::make_unique<VideoFile>(folder / view.source.path, index, threadsFor(view));
    }
    applyBudget(view);
    view.video->setThreads(threadsFor(view));
    return view.video->read(footageFrameAt(view.source, frame), stop, shrink);
}

cv::Mat FrameSource::Impl::fromImage(View& view, int frame) const {
    const cv::Mat picture =
        readRawImage(folder / fillPattern(view.source.path, view.source.camera, footageFrameAt(view.source, frame)));
    return picture.depth() == CV_8U ? picture : toEightBits(picture, levelsOf(view, picture));
}

/// Whatever picture is asked for first, all are shown with the levels of the recording's first one.
GreyLevels FrameSource::Impl::levelsOf(View& view, const cv::Mat& picture) const {
    if (view.source.levels)
        return *view.source.levels;
    const std::lock_guard lock(view.mutex);
    if (!view.guessedLevels) {
        const fs::path first = folder / fillPattern(view.source.path, view.source.camera, view.source.offsetFrames);
        std::error_code ignored;
        view.guessedLevels = levelsByDepth(fs::exists(first, ignored) ? readRawImage(first) : picture);
    }
    return *view.guessedLevels;
}

FrameSource::FrameSource(const Dataset& dataset, const Sequence& sequence, Motion motion)
    : m_impl(std::make_unique<Impl>()) {
    m_impl->folder = dataset.folder;
    m_impl->sequenceName = sequence.name;
    m_impl->frameCount = sequence.frameCount;
    m_impl->cameras = dataset.cameras;
    m_impl->hands = dataset.hands;
    m_impl->motion = std::move(motion);
    for (const Camera& camera : dataset.cameras) {
        m_impl->views.push_back(std::make_unique<View>());
        m_impl->views.back()->source = {camera.name, ViewKind::None, "", 0};
        for (const ViewSource& source : sequence.views)
            if (source.camera == camera.name)
                m_impl->views.back()->source = source;
    }
}

FrameSource::~FrameSource() = default;
FrameSource::FrameSource(FrameSource&&) noexcept = default;
FrameSource& FrameSource::operator=(FrameSource&&) noexcept = default;

int FrameSource::frameCount() const {
    return m_impl->frameCount;
}

ViewKind FrameSource::kind(int camera) const {
    return m_impl->views.at(static_cast<std::size_t>(camera))->source.kind;
}

bool FrameSource::hasPicture(int camera, int frame) const {
    return hasPictureAt(m_impl->views.at(static_cast<std::size_t>(camera))->source, frame);
}

void FrameSource::setFirstCamera(int camera) {
    m_impl->firstCamera = camera;
}

std::optional<Glance> FrameSource::glance(int camera, int frame, bool hurried, const std::stop_token& stop) const {
    View& view = *m_impl->views.at(static_cast<std::size_t>(camera));
    if (view.source.kind != ViewKind::Video || frame < 0 || frame >= m_impl->frameCount ||
        !hasPictureAt(view.source, frame))
        return std::nullopt;
    const std::lock_guard lock(view.mutex);
    if (!view.video || stop.stop_requested())
        return std::nullopt;
    m_impl->applyBudget(view);
    const int wanted = footageFrameAt(view.source, frame);
    const std::optional<VideoGlance> found = view.video->glance(wanted, hurried);
    if (!found)
        return std::nullopt;
    const cv::Mat picture = m_impl->smallAsShown(camera, found->picture);
    return picture.empty() ? std::nullopt : std::optional(Glance{picture, found->frame == wanted});
}

void FrameSource::setBudget(std::int64_t bytes) {
    m_impl->budget = bytes;
}

bool FrameSource::hasVideos() const {
    return m_impl->videoCount() > 0;
}

bool FrameSource::fetchAhead(int camera, int direction, const std::stop_token& stop) const {
    View& view = *m_impl->views.at(static_cast<std::size_t>(camera));
    const std::lock_guard lock(view.mutex);
    if (!view.video)
        return false;
    m_impl->applyBudget(view);
    return view.video->fetchAhead(direction, stop);
}

cv::Mat FrameSource::keptSmall(int camera, int frame) const {
    View& view = *m_impl->views.at(static_cast<std::size_t>(camera));
    if (!hasPicture(camera, frame))
        return {};
    const std::lock_guard lock(view.mutex);
    return view.video ? m_impl->smallAsShown(camera, view.video->keptSmall(footageFrameAt(view.source, frame)))
                      : cv::Mat();
}

bool FrameSource::survey(int camera, const std::stop_token& stop) const {
    View& view = *m_impl->views.at(static_cast<std::size_t>(camera));
    const std::lock_guard lock(view.mutex);
    return view.video && view.video->survey(footageFrameAt(view.source, 0),
                                            footageFrameAt(view.source, m_impl->frameCount - 1), stop);
}

cv::Mat FrameSource::read(int camera, int frame, const std::stop_token& stop, int shrink) const {
    const Camera& calibrated = m_impl->cameras.at(static_cast<std::size_t>(camera));
    View& view = *m_impl->views.at(static_cast<std::size_t>(camera));
    if (frame < 0 || frame >= m_impl->frameCount) {
        throw Error(ErrorCode::NotFound, m_impl->sequenceName, "frame " + std::to_string(frame),
                    "the sequence has frames 0 to " + std::to_string(m_impl->frameCount - 1));
    }
    cv::Mat image;
    if (!hasPictureAt(view.source, frame))
        return renderShaded(calibrated, {});
    switch (view.source.kind) {
    case ViewKind::None:
        break; // has no picture
    case ViewKind::Rendered:
        if (static_cast<std::size_t>(frame) >= m_impl->motion.size())
            throw Error(ErrorCode::NotFound, m_impl->sequenceName, "motion", "there is none to render from");
        return m_impl->rendered(calibrated, frame);
    case ViewKind::Images:
        image = m_impl->fromImage(view, frame);
        break;
    case ViewKind::Video:
        image = m_impl->fromVideo(view, frame, stop, shrink);
        break;
    }
    if (image.empty() && stop.stop_requested())
        return {};
    image = turned(image, view.source.rotateDegrees);
    if (!isSizeOf(image, calibrated.size, shrink)) {
        throw Error(ErrorCode::BadInput, (m_impl->folder / view.source.path).string(), "size",
                    std::to_string(image.cols) + " x " + std::to_string(image.rows) + ", but " + calibrated.name +
                        " is calibrated for " + std::to_string(calibrated.size.width) + " x " +
                        std::to_string(calibrated.size.height));
    }
    return image;
}

fs::path maskFile(const fs::path& datasetFolder, const Sequence& sequence, const std::string& camera, int frame) {
    const std::string pattern = maskPattern(sequence, camera);
    int number = frame;
    for (const ViewSource& view : sequence.views)
        number += view.camera == camera ? view.masksOffset : 0;
    return pattern.empty() ? fs::path() : datasetFolder / fillPattern(pattern, camera, number);
}

std::vector<cv::Mat> readFrameMasks(const fs::path& datasetFolder, const Sequence& sequence,
                                    const std::vector<Camera>& cameras, int frame) {
    std::vector<cv::Mat> masks;
    for (const Camera& camera : cameras) {
        const fs::path file = maskFile(datasetFolder, sequence, camera.name, frame);
        masks.push_back(!file.empty() && fs::exists(file) ? readMask(file) : cv::Mat());
    }
    return masks;
}

} // namespace core
