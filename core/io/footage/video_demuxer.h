// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/io/footage/libav.h"
#include "core/io/footage/video_index.h"

namespace core {

/// The compressed packets of a file's video stream, one after the other.
class VideoDemuxer {
public:
    /// Throws Error(BadInput) if it is not a readable video.
    explicit VideoDemuxer(std::filesystem::path file);

    const AVFormatContext& container() const { return *m_container; }
    const AVStream& stream() const { return *m_container->streams[m_stream]; }
    /// The next packet of the video stream that holds anything; null at the end of the file.
    const AVPacket* next();
    /// Back to the first packet. Throws Error(BadInput) if the file cannot be opened any more; nothing changes then.
    void rewind();
    /// Goes to about where that packet is, or before. False if the container cannot; what comes next must be looked at
    /// in any case.
    bool seekNear(const VideoPacket& packet);

private:
    void open();

    std::filesystem::path m_file;
    ContainerPointer m_container;
    PacketPointer m_packet;
    int m_stream = 0;
};

/// What an index keeps of a packet; its picture is not known yet.
VideoPacket describe(const AVPacket& packet);

} // namespace core
