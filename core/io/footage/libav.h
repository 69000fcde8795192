// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace core {

struct LibavDeleter {
    void operator()(AVFormatContext* container) const { avformat_close_input(&container); }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};

using ContainerPointer = std::unique_ptr<AVFormatContext, LibavDeleter>;
using CodecPointer = std::unique_ptr<AVCodecContext, LibavDeleter>;
using PacketPointer = std::unique_ptr<AVPacket, LibavDeleter>;
using FramePointer = std::unique_ptr<AVFrame, LibavDeleter>;

/// The library's words for one of its error numbers.
inline std::string libavMessage(int error) {
    char text[AV_ERROR_MAX_STRING_SIZE] = {};
    av_strerror(error, text, sizeof text);
    return text;
}

} // namespace core
