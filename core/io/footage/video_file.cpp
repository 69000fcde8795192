// SPDX-License-Identifier: MIT
#include "core/io/footage/video_file.h"

#include <cstdlib>
#include <map>
#include <utility>

#include "core/error.h"
#include "core/io/footage/key_pictures.h"
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

/// Pictures that there was no more room for, shrunk.
class ShrunkPictures {
public:
    void setBudget(std::int64_t bytes) { m_budget = bytes; }
    bool isUsed() const { return m_budget > 0; }
    void keep(int frame, const cv::Mat& picture, int focus) {
        m_bytes += bytesOf(picture) - bytesOf(std::exchange(m_kept[frame], picture));
        while (m_bytes > m_budget && !m_kept.empty()) { // the farthest goes
            const auto first = m_kept.begin(), last = std::prev(m_kept.end());
            const auto least = focus - first->first > last->first - focus ? first : last;
            m_bytes -= bytesOf(least->second);
            m_kept.erase(least);
        }
    }
    cv::Mat find(int frame) const {
        const auto found = m_kept.find(frame);
        return found == m_kept.end() ? cv::Mat() : found->second;
    }

private:
    static std::int64_t bytesOf(const cv::Mat& picture) {
        return static_cast<std::int64_t>(picture.total() * picture.elemSize());
    }

    std::map<int, cv::Mat> m_kept;
    std::int64_t m_bytes = 0, m_budget = 0;
};

struct VideoFile::Handle {
    PictureReader reader;
    KeyPictures keys;
    PictureConverter converter;
    ShrunkPictures shrunk;
    int focus = 0; ///< the last frame that was read
};

VideoFile::VideoFile(fs::path file, const fs::path& indexFile, int threads)
    : m_file(std::move(file)) {
    const auto index = std::make_shared<const VideoIndex>(indexOf(m_file, indexFile));
    m_info = infoOf(*index);
    m_handle.reset(new Handle{PictureReader(m_file, index, threads > 0 ? threads : VideoDecoder::usualThreads()),
                              KeyPictures(m_file, index),
                              {},
                              {}});
    m_handle->reader.setOnForgotten([this](int frame, const AVFrame& picture) {
        if (m_handle->shrunk.isUsed() && picture.width == m_info.size.width && picture.height == m_info.size.height)
            m_handle->shrunk.keep(frame, m_handle->converter.toBgr(picture, kGlanceShrink), m_handle->focus);
    });
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

std::optional<VideoGlance> VideoFile::glance(int frame) {
    constexpr int kQuick = 3; ///< packets
    PictureReader& reader = m_handle->reader;
    if (frame < 0 || frame >= m_info.frames || reader.packetsUntil(frame) <= kQuick)
        return std::nullopt;
    if (cv::Mat exact = m_handle->shrunk.find(frame); !exact.empty())
        return VideoGlance{frame, exact};
    int number = 0;
    const AVFrame* picture = reader.nearest(frame, number);
    if (const std::optional<int> key = m_handle->keys.nearest(frame);
        key && (picture == nullptr || std::abs(*key - frame) < std::abs(number - frame))) {
        if (cv::Mat kept = m_handle->shrunk.find(*key); !kept.empty())
            return VideoGlance{*key, kept};
        number = *key;
        picture = m_handle->keys.read(*key);
    }
    if (picture == nullptr || VideoDecoder::isDamaged(*picture) || picture->width != m_info.size.width ||
        picture->height != m_info.size.height)
        return std::nullopt;
    VideoGlance glance{number, m_handle->converter.toBgr(*picture, kGlanceShrink)};
    if (m_handle->shrunk.isUsed() && !glance.picture.empty())
        m_handle->shrunk.keep(number, glance.picture, frame);
    return glance.picture.empty() ? std::nullopt : std::optional(std::move(glance));
}

void VideoFile::setThreads(int threads) {
    m_handle->reader.setThreads(threads);
}

/// As decoded, a picture takes eight times the memory of a shrunk one.
void VideoFile::setBudget(std::int64_t bytes) {
    m_handle->shrunk.setBudget(bytes / 4);
    m_handle->reader.setBudget(bytes - bytes / 4);
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
    return infoOf(indexOf(file, indexFile));
}

} // namespace core
