// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/geometry/camera.h"
#include "core/io/footage/small_pictures.h"

namespace core {

/// What a video file holds.
struct VideoInfo {
    int frames = 0;
    ImageSize size;
    double framesPerSecond = 0;     ///< 0 = unknown
    std::vector<double> timesSec{}; ///< when each frame is shown; empty if the file does not tell
    int rotationDegrees = 0;        ///< clockwise turn with which a player shows the recorded pixels: 0, 90, 180 or 270
};

/// A frame at 1 / kGlanceShrink of its size.
struct VideoGlance {
    int frame = 0; ///< which one it is
    cv::Mat picture;
};

/// A video with exact access to every frame: frame n is the n-th picture of decoding from the start, in the order of
/// presentation, in whatever order frames are read. It is indexed once. Not for several threads at once.
class VideoFile {
public:
    /// `indexFile` is where the index is kept between runs; empty, not writable, damaged or stale, the video is indexed
    /// anew. `threads` decode; 0 = as many as the machine has, at most 4. Throws Error: NotFound, or BadInput if it is
    /// not a readable video.
    VideoFile(std::filesystem::path file, const std::filesystem::path& indexFile, int threads = 0);
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    const VideoInfo& info() const { return m_info; }
    /// The frame as CV_8UC3 BGR. Throws Error: NotFound beyond the end, BadInput if it cannot be decoded.
    /// Empty if it was stopped.
    /// `shrink` above 1: the picture at 1 / shrink of its size (rounded up), for much less work.
    cv::Mat read(int frame, const std::stop_token& stop = {}, int shrink = 1);
    /// What can be shown at once while that frame would take long to read: the frame itself, kept at 1 / kGlanceShrink
    /// of its size, or the nearest one that is kept or a key picture. No value where read() is quick, or there is none.
    /// `hurried`: reading a frame that is not kept counts as slow, however near it is, if it is kept small.
    std::optional<VideoGlance> glance(int frame, bool hurried = false);
    /// How many threads decode, from the next jump on.
    void setThreads(int threads);
    /// How much memory pictures near the last frame may take: most of it as decoded, a part small, farther away. Small
    /// ones are kept beside the index instead, if there is one, and may take as much of the disk. A few are kept at
    /// first, none of them small.
    void setBudget(std::int64_t bytes);
    /// The frame at 1 / kGlanceShrink of its size, if it is kept so; else empty.
    cv::Mat keptSmall(int frame);
    /// Decodes a frame from `first` to `last` that is not kept small, near the last one that was read, and keeps it so.
    /// Decoding ahead and reading go on unharmed. False if nothing is left to do, or it was stopped.
    bool survey(int first, int last, const std::stop_token& stop);
    /// Decodes the nearest frame that is not kept before (direction -1) or after (+1) the last one that was read. False
    /// if all that fits is kept, or it was stopped.
    bool fetchAhead(int direction, const std::stop_token& stop);
    /// True if the frame can be had without decoding.
    bool isKept(int frame) const;

private:
    struct Handle;
    std::filesystem::path m_file;
    std::unique_ptr<Handle> m_handle;
    VideoInfo m_info;
};

/// Throws Error if it is not a readable video. `indexFile` as for VideoFile; the index takes long to make for a long
/// video.
VideoInfo readVideoInfo(const std::filesystem::path& file, const std::filesystem::path& indexFile = {});

/// The size of the pictures as the file's header says, which takes no time. Throws Error if it is not a readable video.
ImageSize readVideoSize(const std::filesystem::path& file);

} // namespace core
