// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "core/io/footage/libav.h"
#include "core/io/footage/video_index.h"

namespace core {

/// The compressed packets of a file's video stream, one after the other.
class VideoDemuxer {
public:
    /// Throws Error(BadInput) if it is not a readable video.
    explicit VideoDemuxer(std::filesystem::path file);
    /// Another reader of the same file, at its first packet. The pictures that tell what the stream is are not decoded
    /// again, if the container's header tells that it is the same. Throws Error(BadInput) if it cannot be opened.
    VideoDemuxer another() const;

    const std::filesystem::path& file() const { return m_file; }
    const AVFormatContext& container() const { return *m_container; }
    const AVStream& stream() const { return *m_container->streams[m_analysis->stream]; }
    /// The next packet of the video stream that holds anything; null at the end of the file.
    const AVPacket* next();
    /// Back to the first packet. Throws Error(BadInput) if the file cannot be opened any more; nothing changes then.
    void rewind();
    /// Goes to about where that packet is, or before. False if the container cannot; what comes next must be looked at
    /// in any case.
    bool seekNear(const VideoPacket& packet);

private:
    /// What is told by decoding the first pictures.
    struct Analysis {
        int stream = 0;
        CodecParametersPointer codec;
        AVRational averageRate{}, rate{};
    };

    VideoDemuxer(std::filesystem::path file, std::shared_ptr<const Analysis> known);
    void open();
    void analyse(AVFormatContext& container);
    bool isKnown(const AVFormatContext& container) const;

    std::filesystem::path m_file;
    ContainerPointer m_container;
    PacketPointer m_packet;
    std::shared_ptr<const Analysis> m_analysis; ///< null before the file was opened
};

/// What an index keeps of a packet; its picture is not known yet.
VideoPacket describe(const AVPacket& packet);

} // namespace core
