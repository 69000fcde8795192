// SPDX-License-Identifier: MIT
#include "core/io/footage/video_file.h"

#include <cstdlib>
#include <utility>

#include "core/error.h"
#include "core/io/footage/key_pictures.h"
#include "core/io/footage/picture_converter.h"
#include "core/io/footage/picture_reader.h"
#include "core/io/footage/picture_survey.h"
#include "core/io/footage/small_pictures.h"
#include "core/io/footage/video_indexer.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// Throws Error(NotFound) if there is no such video.
std::optional<VideoIndex> keptIndex(const fs::path& file, const fs::path& indexFile) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored))
        throw Error(ErrorCode::NotFound, file.string(), "", "no such video");
    return indexFile.empty() ? std::nullopt : readVideoIndex(indexFile, file);
}

/// Which is then kept.
VideoIndex newIndex(VideoDemuxer& video, const fs::path& indexFile) {
    VideoIndex index = indexVideo(video);
    if (!indexFile.empty())
        keepVideoIndex(index, indexFile);
    return index;
}

VideoInfo infoOf(const VideoIndex& index) {
    VideoInfo info;
    info.frames = index.pictures();
    info.size = index.size;
    info.framesPerSecond = index.framesPerSecond;
    info.timesSec = index.timesSec;
    info.rotationDegrees = index.rotationDegrees;
    return info;
}

std::string sizeText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

} // namespace

struct VideoFile::Handle {
    Handle(VideoDemuxer video, const std::shared_ptr<const VideoIndex>& kept, fs::path fileOfSmall, int threads)
        : index(kept)
        , smallFile(std::move(fileOfSmall))
        , reader(std::move(video), index, threads > 0 ? threads : VideoDecoder::usualThreads())
        , keys(reader.video(), index)
        , survey(reader.video(), index) {
        reader.setOnForgotten([this](int frame, const AVFrame& picture) { keepSmall(frame, picture); });
    }
    void keepSmall(int frame, const AVFrame& picture) {
        if (small && !small->has(frame) && picture.width == index->size.width && picture.height == index->size.height)
            small->keep(frame, converter.toBgr(picture, kGlanceShrink), focus);
    }

    std::shared_ptr<const VideoIndex> index;
    fs::path smallFile; ///< empty: none
    PictureReader reader;
    KeyPictures keys;
    PictureSurvey survey;
    PictureConverter converter;
    std::optional<SmallPictures> small; ///< from the first budget on
    int focus = 0;                      ///< the last frame that was read
};

VideoFile::VideoFile(fs::path file, const fs::path& indexFile, int threads)
    : m_file(std::move(file)) {
    std::optional<VideoIndex> index = keptIndex(m_file, indexFile);
    VideoDemuxer video(m_file);
    if (!index) {
        index = newIndex(video, indexFile);
        video.rewind();
    }
    m_info = infoOf(*index);
    const fs::path small = indexFile.empty() ? fs::path() : fs::path(indexFile).replace_extension(".smallpictures");
    m_handle = std::make_unique<Handle>(std::move(video), std::make_shared<const VideoIndex>(std::move(*index)), small,
                                        threads);
}

VideoFile::~VideoFile() = default;

cv::Mat VideoFile::read(int frame, const std::stop_token& stop, int shrink) {
    const std::string field = "frame " + std::to_string(frame);
    if (frame < 0 || frame >= m_info.frames) {
        throw Error(ErrorCode::NotFound, m_file.string(), field,
                    "the video has frames 0 to " + std::to_string(m_info.frames - 1));
    }
    m_handle->focus = frame;
    const AVFrame* decoded = m_handle->reader.read(frame, stop);
    if (decoded == nullptr)
        return {};
    const AVFrame& picture = *decoded;
    if (picture.width != m_info.size.width || picture.height != m_info.size.height) {
        throw Error(ErrorCode::BadInput, m_file.string(), field,
                    sizeText(picture.width, picture.height) + ", but the video begins with " +
                        sizeText(m_info.size.width, m_info.size.height));
    }
    cv::Mat image = m_handle->converter.toBgr(picture, shrink);
    if (image.empty())
        throw Error(ErrorCode::Unsupported, m_file.string(), field, "its pixel format is not supported");
    return image;
}

std::optional<VideoGlance> VideoFile::glance(int frame, bool hurried) {
    constexpr int kQuickPackets = 3;
    constexpr std::int64_t kQuickBytes = 1 << 21; ///< which take about a quarter of a second
    PictureReader& reader = m_handle->reader;
    if (frame < 0 || frame >= m_info.frames || reader.isKept(frame))
        return std::nullopt;
    const bool isQuick = reader.packetsUntil(frame) <= kQuickPackets && reader.bytesUntil(frame) <= kQuickBytes;
    if (!isQuick || hurried)
        if (cv::Mat exact = keptSmall(frame); !exact.empty())
            return VideoGlance{frame, exact};
    if (isQuick)
        return std::nullopt;
    int number = 0;
    const AVFrame* picture = reader.nearest(frame, number);
    if (const std::optional<int> key = m_handle->keys.nearest(frame);
        key && (picture == nullptr || std::abs(*key - frame) < std::abs(number - frame))) {
        if (cv::Mat kept = keptSmall(*key); !kept.empty())
            return VideoGlance{*key, kept};
        number = *key;
        picture = m_handle->keys.read(*key);
    }
    if (picture == nullptr || VideoDecoder::isDamaged(*picture) || picture->width != m_info.size.width ||
        picture->height != m_info.size.height)
        return std::nullopt;
    VideoGlance glance{number, m_handle->converter.toBgr(*picture, kGlanceShrink)};
    if (m_handle->small && !glance.picture.empty())
        m_handle->small->keep(number, glance.picture, frame);
    return glance.picture.empty() ? std::nullopt : std::optional(std::move(glance));
}

void VideoFile::setThreads(int threads) {
    m_handle->reader.setThreads(threads);
}

void VideoFile::setBudget(std::int64_t bytes) {
    Handle& handle = *m_handle;
    if (!handle.small) {
        const VideoIndex& index = *handle.index;
        const auto shrunk = [](int side) { return (side + kGlanceShrink - 1) / kGlanceShrink; };
        handle.small.emplace(handle.smallFile, FileStamp{index.fileSize, index.fileTime},
                             cv::Size(shrunk(index.size.width), shrunk(index.size.height)));
    }
    handle.small->setBudget(bytes / 4, bytes);
    handle.reader.setBudget(bytes - bytes / 4);
}

cv::Mat VideoFile::keptSmall(int frame) {
    return m_handle->small ? m_handle->small->find(frame) : cv::Mat();
}

bool VideoFile::survey(int first, int last, const std::stop_token& stop) {
    return m_handle->small && m_handle->survey.step(*m_handle->small, m_handle->focus, first, last, stop);
}

bool VideoFile::fetchAhead(int direction, const std::stop_token& stop) {
    return m_handle->reader.fetchAhead(direction < 0 ? -1 : 1, stop);
}

bool VideoFile::isKept(int frame) const {
    return m_handle->reader.isKept(frame);
}

ImageSize readVideoSize(const fs::path& file) {
    const VideoDemuxer demuxer(file);
    return {demuxer.stream().codecpar->width, demuxer.stream().codecpar->height};
}

VideoInfo readVideoInfo(const fs::path& file, const fs::path& indexFile) {
    std::optional<VideoIndex> index = keptIndex(file, indexFile);
    if (!index) {
        VideoDemuxer video(file);
        index = newIndex(video, indexFile);
    }
    return infoOf(*index);
}

} // namespace core
