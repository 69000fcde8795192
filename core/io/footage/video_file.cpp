// SPDX-License-Identifier: MIT
#include "core/io/footage/video_file.h"

#include "core/error.h"
#include "core/io/footage/picture_converter.h"
#include "core/io/footage/picture_reader.h"
#include "core/io/footage/video_indexer.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// The kept index, or a new one, which is then kept.
VideoIndex indexOf(const fs::path& file, const fs::path& indexFile) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored))
        throw Error(ErrorCode::NotFound, file.string(), "", "no such video");
    std::optional<VideoIndex> index = indexFile.empty() ? std::nullopt : readVideoIndex(indexFile, file);
    if (!index) {
        index = indexVideo(file);
        if (!indexFile.empty())
            keepVideoIndex(*index, indexFile);
    }
    return std::move(*index);
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
    PictureReader reader;
    PictureConverter converter;
};

VideoFile::VideoFile(fs::path file, const fs::path& indexFile, int threads)
    : m_file(std::move(file)) {
    VideoIndex index = indexOf(m_file, indexFile);
    m_info = infoOf(index);
    m_handle.reset(
        new Handle{PictureReader(m_file, std::move(index), threads > 0 ? threads : VideoDecoder::usualThreads()), {}});
}

VideoFile::~VideoFile() = default;

cv::Mat VideoFile::read(int frame, const std::stop_token& stop) {
    const std::string field = "frame " + std::to_string(frame);
    if (frame < 0 || frame >= m_info.frames) {
        throw Error(ErrorCode::NotFound, m_file.string(), field,
                    "the video has frames 0 to " + std::to_string(m_info.frames - 1));
    }
    const AVFrame* decoded = m_handle->reader.read(frame, stop);
    if (decoded == nullptr)
        return {};
    const AVFrame& picture = *decoded;
    if (picture.width != m_info.size.width || picture.height != m_info.size.height) {
        throw Error(ErrorCode::BadInput, m_file.string(), field,
                    sizeText(picture.width, picture.height) + ", but the video begins with " +
                        sizeText(m_info.size.width, m_info.size.height));
    }
    cv::Mat image = m_handle->converter.toBgr(picture);
    if (image.empty())
        throw Error(ErrorCode::Unsupported, m_file.string(), field, "its pixel format is not supported");
    return image;
}

void VideoFile::setBudget(std::int64_t bytes) {
    m_handle->reader.setBudget(bytes);
}

bool VideoFile::fetchAhead(int direction, const std::stop_token& stop) {
    return m_handle->reader.fetchAhead(direction < 0 ? -1 : 1, stop);
}

bool VideoFile::isKept(int frame) const {
    return m_handle->reader.isKept(frame);
}

VideoInfo readVideoInfo(const fs::path& file, const fs::path& indexFile) {
    return infoOf(indexOf(file, indexFile));
}

} // namespace core
