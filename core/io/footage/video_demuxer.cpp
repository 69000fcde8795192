// SPDX-License-Identifier: MIT
#include "core/io/footage/video_demuxer.h"

#include <mutex>
#include <string_view>

#include "core/error.h"
#include "core/io/files/content_hash.h"

namespace core {

namespace fs = std::filesystem;

namespace {

Error notReadable(const fs::path& file, const std::string& why) {
    return Error(ErrorCode::BadInput, file.string(), "", "not a readable video (" + why + ")");
}

/// Its messages would land between ours.
void silenceLibrary() {
    static std::once_flag once;
    std::call_once(once, [] { av_log_set_level(AV_LOG_QUIET); });
}

} // namespace

VideoDemuxer::VideoDemuxer(fs::path file)
    : m_file(std::move(file))
    , m_packet(av_packet_alloc()) {
    silenceLibrary();
    open();
}

void VideoDemuxer::open() {
    m_container.reset();
    AVFormatContext* container = nullptr;
    const std::string url = "file:" + m_file.string(); // never a protocol that a file's name spells
    if (const int failed = avformat_open_input(&container, url.c_str(), nullptr, nullptr); failed < 0)
        throw notReadable(m_file, libavMessage(failed));
    m_container.reset(container);
    if (std::string_view(container->iformat->name) == "tty") // text drawn as pictures
        throw notReadable(m_file, "it is a text file");
    if (const int failed = avformat_find_stream_info(container, nullptr); failed < 0)
        throw notReadable(m_file, libavMessage(failed));
    m_stream = av_find_best_stream(container, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (m_stream < 0)
        throw notReadable(m_file, "it has no video stream");
    for (unsigned s = 0; s < container->nb_streams; ++s)
        container->streams[s]->discard = static_cast<int>(s) == m_stream ? AVDISCARD_DEFAULT : AVDISCARD_ALL;
}

const AVPacket* VideoDemuxer::next() {
    constexpr int kMostFailures = 16; // a damaged spot; some containers go on after it
    for (int failures = 0; failures < kMostFailures;) {
        av_packet_unref(m_packet.get());
        const int result = av_read_frame(m_container.get(), m_packet.get());
        if (result == AVERROR_EOF)
            return nullptr;
        if (result < 0)
            ++failures;
        else if (m_packet->stream_index == m_stream && m_packet->size > 0)
            return m_packet.get();
    }
    return nullptr;
}

void VideoDemuxer::rewind() {
    open();
}

bool VideoDemuxer::seekNear(const VideoPacket& packet) {
    const int flags = m_container->iformat->flags;
    const bool hasTimes = (flags & (AVFMT_TS_DISCONT | AVFMT_NOTIMESTAMPS)) == 0;
    if (hasTimes) {
        const std::int64_t time = packet.dts != VideoPacket::kNoTime ? packet.dts : packet.pts;
        return time != VideoPacket::kNoTime &&
               av_seek_frame(m_container.get(), m_stream, time, AVSEEK_FLAG_BACKWARD) >= 0;
    }
    return packet.position >= 0 && (flags & AVFMT_NO_BYTE_SEEK) == 0 &&
           av_seek_frame(m_container.get(), m_stream, packet.position, AVSEEK_FLAG_BYTE) >= 0;
}

VideoPacket describe(const AVPacket& packet) {
    static_assert(VideoPacket::kNoTime == AV_NOPTS_VALUE);
    VideoPacket result;
    result.pts = packet.pts;
    result.dts = packet.dts;
    result.position = packet.pos;
    result.size = static_cast<std::uint32_t>(packet.size);
    result.hash = contentHash(packet.data, static_cast<std::size_t>(packet.size));
    result.isKey = (packet.flags & AV_PKT_FLAG_KEY) != 0;
    return result;
}

} // namespace core
