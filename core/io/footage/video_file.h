// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/geometry/camera.h"

namespace core {

/// What a video file holds.
struct VideoInfo {
    int frames = 0;
    ImageSize size;
    double framesPerSecond = 0;     ///< 0 = unknown
    std::vector<double> timesSec{}; ///< when each frame is shown; empty if the file does not tell
    int rotationDegrees = 0;        ///< clockwise turn with which a player shows the recorded pixels: 0, 90, 180 or 270
};

/// A video with exact access to every frame: frame n is the n-th picture of decoding from the start, in the order of
/// presentation, in whatever order frames are read. It is indexed once. Not for several threads at once.
class VideoFile {
public:
    /// `indexFile` is where the index is kept between runs; empty, not writable, damaged or stale, the video is indexed
    /// anew. Throws Error: NotFound, or BadInput if it is not a readable video.
    VideoFile(std::filesystem::path file, const std::filesystem::path& indexFile);
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    const VideoInfo& info() const { return m_info; }
    /// The frame as CV_8UC3 BGR. Throws Error: NotFound beyond the end, BadInput if it cannot be decoded.
    cv::Mat read(int frame);

private:
    struct Handle;
    std::filesystem::path m_file;
    std::unique_ptr<Handle> m_handle;
    VideoInfo m_info;
};

/// Throws Error if it is not a readable video. `indexFile` as for VideoFile; the index takes long to make for a long
/// video.
VideoInfo readVideoInfo(const std::filesystem::path& file, const std::filesystem::path& indexFile = {});

} // namespace core
