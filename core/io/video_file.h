// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include <opencv2/core/mat.hpp>

#include "core/io/frames.h"

namespace core {

/// A video with exact access to every frame: frame n is the n-th picture of decoding from the start, in the order of presentation, in
/// whatever order frames are read. It is indexed once. Not for several threads at once.
class VideoFile {
public:
    /// `indexFile` is where the index is kept between runs; empty, not writable, damaged or stale, the video is indexed anew.
    /// Throws Error: NotFound, or BadInput if it is not a readable video.
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

} // namespace core
