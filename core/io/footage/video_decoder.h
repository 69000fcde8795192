// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/io/footage/libav.h"

namespace core {

/// Decodes packets into pictures, each of which says which packet it comes from.
class VideoDecoder {
public:
    /// `threads` work on the stream. Throws Error(Unsupported), naming `file`, if there is no decoder for it.
    VideoDecoder(const AVStream& stream, const std::string& file, int threads = 1);

    /// As many as the machine has, at most 4.
    static int usualThreads();

    /// Takes the packet with this number; null = the stream has ended, give out what is held back. `number` comes back
    /// with the picture that the packet holds (the decoder reorders pictures and may drop some). False if the packet is
    /// damaged.
    bool send(const AVPacket* packet, int number);
    /// The next picture in the order of presentation, or null if another packet is needed (or all is given out). Valid
    /// until the next call.
    const AVFrame* receive();
    /// The number of the packet that this picture comes from.
    static int packetOf(const AVFrame& picture) { return static_cast<int>(picture.pts); }
    /// The decoder had to guess at parts of this picture.
    static bool isDamaged(const AVFrame& picture);
    /// Errors since the last restart.
    int errors() const { return m_errors; }
    /// Leaves out the smoothing of edges between blocks, from the next packet on: for pictures that are looked at for a
    /// moment.
    void setQuick();
    /// Forgets everything: the next packet may be from anywhere.
    void restart();

private:
    CodecPointer m_codec;
    PacketPointer m_packet;
    FramePointer m_picture;
    int m_errors = 0;
};

} // namespace core
