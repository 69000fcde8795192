// SPDX-License-Identifier: MIT
#include "core/io/footage/video_decoder.h"

#include <algorithm>
#include <thread>

#include "core/error.h"

namespace core {

VideoDecoder::VideoDecoder(const AVStream& stream, const std::string& file, int threads)
    : m_packet(av_packet_alloc())
    , m_picture(av_frame_alloc()) {
    const AVCodec* codec = avcodec_find_decoder(stream.codecpar->codec_id);
    if (codec == nullptr) {
        throw Error(ErrorCode::Unsupported, file, "",
                    std::string("not a readable video (no decoder for ") + avcodec_get_name(stream.codecpar->codec_id) +
                        ")");
    }
    m_codec.reset(avcodec_alloc_context3(codec));
    int failed = avcodec_parameters_to_context(m_codec.get(), stream.codecpar);
    m_codec->thread_count = std::max(1, threads);
    m_codec->max_pixels = kMostPixels;
    failed = failed < 0 ? failed : avcodec_open2(m_codec.get(), codec, nullptr);
    if (failed < 0)
        throw Error(ErrorCode::BadInput, file, "", "not a readable video (" + libavMessage(failed) + ")");
}

int VideoDecoder::usualThreads() {
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 4);
}

bool VideoDecoder::send(const AVPacket* packet, int number) {
    int result = 0;
    if (packet != nullptr) {
        // Decoders carry a packet's time stamp to its picture and do not use it themselves: it carries the number.
        av_packet_ref(m_packet.get(), packet);
        m_packet->pts = number;
        m_packet->dts = AV_NOPTS_VALUE;
        result = avcodec_send_packet(m_codec.get(), m_packet.get());
        av_packet_unref(m_packet.get());
    } else {
        result = avcodec_send_packet(m_codec.get(), nullptr);
    }
    m_errors += result < 0 ? 1 : 0;
    return result >= 0;
}

const AVFrame* VideoDecoder::receive() {
    for (int failures = 0; failures < 64;) {
        const int result = avcodec_receive_frame(m_codec.get(), m_picture.get());
        if (result == AVERROR(EAGAIN) || result == AVERROR_EOF)
            return nullptr;
        if (result >= 0)
            return m_picture.get();
        ++m_errors; // of a packet that was sent before
        ++failures;
    }
    return nullptr;
}

bool VideoDecoder::isDamaged(const AVFrame& picture) {
    return picture.decode_error_flags != 0 || (picture.flags & AV_FRAME_FLAG_CORRUPT) != 0;
}

void VideoDecoder::setQuick() {
    m_codec->skip_loop_filter = AVDISCARD_ALL;
}

void VideoDecoder::restart() {
    avcodec_flush_buffers(m_codec.get());
    m_errors = 0;
}

} // namespace core
