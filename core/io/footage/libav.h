// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace core {

/// Pictures of 8192 x 8192 pixels are the largest that are read.
inline constexpr std::int64_t kMostPixels = std::int64_t(1) << 26;

struct LibavDeleter {
    /// Closes the file, too, where we opened it.
    void operator()(AVFormatContext* container) const {
        AVIOContext* file = (container->flags & AVFMT_FLAG_CUSTOM_IO) != 0 ? container->pb : nullptr;
        avformat_close_input(&container);
        avio_closep(&file);
    }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVCodecParameters* parameters) const { avcodec_parameters_free(&parameters); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};

using ContainerPointer = std::unique_ptr<AVFormatContext, LibavDeleter>;
using CodecPointer = std::unique_ptr<AVCodecContext, LibavDeleter>;
using CodecParametersPointer = std::unique_ptr<AVCodecParameters, LibavDeleter>;
using PacketPointer = std::unique_ptr<AVPacket, LibavDeleter>;
using FramePointer = std::unique_ptr<AVFrame, LibavDeleter>;

/// The library's words for one of its error numbers.
inline std::string libavMessage(int error) {
    char text[AV_ERROR_MAX_STRING_SIZE] = {};
    av_strerror(error, text, sizeof text);
    return text;
}

} // namespace core
