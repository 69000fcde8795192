// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/camera.h"

namespace core {

/// One packet of a video's compressed stream, in the order of the file (which is the order of decoding).
struct VideoPacket {
    std::int64_t pts = 0, dts = 0; ///< in the stream's time base; kNoTime = the file does not tell
    std::int64_t position = -1;    ///< bytes from the file's begin, of the packet or of what contains it
    std::uint32_t size = 0;
    std::uint64_t hash = 0; ///< of its content
    bool isKey = false;     ///< decoding may start here
    int picture = -1;       ///< number of the picture that it holds; -1 = none is shown
    bool operator==(const VideoPacket&) const = default;

    static constexpr std::int64_t kNoTime = INT64_MIN;
};

/// Which packet holds which picture of a video file, made once and kept beside the dataset.
/// Picture n is the n-th that decoding from the start yields, in the order of presentation.
struct VideoIndex {
    std::uint64_t fileSize = 0; ///< of the video, bytes
    std::int64_t fileTime = 0;  ///< when it was last changed
    ImageSize size;
    double framesPerSecond = 0; ///< 0 = unknown
    int rotationDegrees = 0;    ///< clockwise; 0, 90, 180 or 270
    /// The pictures cannot be told by their packets: picture n is only to be had by counting from the start.
    bool isCounted = false;
    std::vector<VideoPacket> packets;
    std::vector<int> packetOfPicture; ///< index into packets, by picture
    std::vector<double> timesSec;     ///< by picture; empty = the file does not tell
    bool operator==(const VideoIndex&) const = default;

    int pictures() const { return static_cast<int>(packetOfPicture.size()); }
    /// The last packet at which decoding can start so that this picture comes out whole, at most `before`. 0 if there
    /// is no other.
    int startFor(int picture, int before) const;
};

/// The index in `indexFile` if it is whole and of this very video (its size and time of change); else nothing.
std::optional<VideoIndex> readVideoIndex(const std::filesystem::path& indexFile, const std::filesystem::path& video);
/// Keeps an index, atomically. It is a convenience: nothing happens where the folder cannot be written.
void keepVideoIndex(const VideoIndex& index, const std::filesystem::path& indexFile);

/// Size and time of change of a file, as an index keeps them.
struct FileStamp {
    std::uint64_t size = 0;
    std::int64_t time = 0;
};
FileStamp stampOf(const std::filesystem::path& file);

} // namespace core
