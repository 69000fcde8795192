// SPDX-License-Identifier: MIT
#include "core/io/footage/video_demuxer.h"

#include <mutex>
#include <string_view>
#include <vector>

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

/// The file is opened here, and the library may open no other: a playlist that is named like a video would have it read
/// whatever files it lists.
ContainerPointer openContainer(const fs::path& file) {
    AVIOContext* bytes = nullptr;
    const std::string url = "file:" + file.string(); // never a protocol that a file's name spells
    int failed = avio_open2(&bytes, url.c_str(), AVIO_FLAG_READ, nullptr, nullptr);
    AVFormatContext* container = failed < 0 ? nullptr : avformat_alloc_context();
    if (container != nullptr) {
        container->pb = bytes;
        AVDictionary* options = nullptr;
        av_dict_set(&options, "protocol_whitelist", "none", 0);
        failed = avformat_open_input(&container, url.c_str(), nullptr, &options);
        av_dict_free(&options);
    }
    if (container == nullptr) {
        avio_closep(&bytes);
        throw notReadable(file, libavMessage(failed < 0 ? failed : AVERROR(ENOMEM)));
    }
    return ContainerPointer(container);
}

/// Decodes the beginning of each stream, as far as is needed to know it.
int findStreams(AVFormatContext& container) {
    std::vector<AVDictionary*> options(container.nb_streams, nullptr);
    for (AVDictionary*& option : options)
        av_dict_set_int(&option, "max_pixels", kMostPixels, 0);
    const int result = avformat_find_stream_info(&container, options.empty() ? nullptr : options.data());
    for (AVDictionary*& option : options)
        av_dict_free(&option);
    return result;
}

/// A header of a few bytes can ask for pictures that fill the memory.
void requirePictureSizes(const AVFormatContext& container, const fs::path& file) {
    for (unsigned s = 0; s < container.nb_streams; ++s) {
        const AVCodecParameters& codec = *container.streams[s]->codecpar;
        if (codec.codec_type == AVMEDIA_TYPE_VIDEO && std::int64_t(codec.width) * codec.height > kMostPixels)
            throw notReadable(file, "pictures of " + std::to_string(codec.width) + " x " +
                                        std::to_string(codec.height) + " are too large");
    }
}

} // namespace

VideoDemuxer::VideoDemuxer(fs::path file)
    : VideoDemuxer(std::move(file), nullptr) {}

VideoDemuxer::VideoDemuxer(fs::path file, std::shared_ptr<const Analysis> known)
    : m_file(std::move(file))
    , m_packet(av_packet_alloc())
    , m_analysis(std::move(known)) {
    silenceLibrary();
    open();
}

VideoDemuxer VideoDemuxer::another() const {
    return {m_file, m_analysis};
}

void VideoDemuxer::open() {
    ContainerPointer container = openContainer(m_file);
    if (std::string_view(container->iformat->name) == "tty") // text drawn as pictures
        throw notReadable(m_file, "it is a text file");
    requirePictureSizes(*container, m_file);
    if (!isKnown(*container))
        analyse(*container);
    AVStream& stream = *container->streams[m_analysis->stream];
    avcodec_parameters_copy(stream.codecpar, m_analysis->codec.get());
    stream.avg_frame_rate = m_analysis->averageRate;
    stream.r_frame_rate = m_analysis->rate;
    for (unsigned s = 0; s < container->nb_streams; ++s)
        container->streams[s]->discard = static_cast<int>(s) == m_analysis->stream ? AVDISCARD_DEFAULT : AVDISCARD_ALL;
    m_container = std::move(container); // the former one stays where the file cannot be opened again
}

void VideoDemuxer::analyse(AVFormatContext& container) {
    if (const int failed = findStreams(container); failed < 0)
        throw notReadable(m_file, libavMessage(failed));
    requirePictureSizes(container, m_file); // some are only told by the pictures
    const int stream = av_find_best_stream(&container, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (stream < 0)
        throw notReadable(m_file, "it has no video stream");
    const AVStream& video = *container.streams[stream];
    auto analysis = std::make_shared<Analysis>();
    analysis->stream = stream;
    analysis->codec.reset(avcodec_parameters_alloc());
    avcodec_parameters_copy(analysis->codec.get(), video.codecpar);
    analysis->averageRate = video.avg_frame_rate;
    analysis->rate = video.r_frame_rate;
    m_analysis = std::move(analysis);
}

/// Whether the stream is the one that was analysed, in a container that says all about its packets itself.
bool VideoDemuxer::isKnown(const AVFormatContext& container) const {
    const std::string_view format = container.iformat->name;
    if (!m_analysis || (!format.starts_with("mov,") && !format.starts_with("matroska,")) ||
        (container.ctx_flags & AVFMTCTX_NOHEADER) != 0 || m_analysis->stream >= static_cast<int>(container.nb_streams))
        return false;
    const AVCodecParameters& now = *container.streams[m_analysis->stream]->codecpar;
    const AVCodecParameters& then = *m_analysis->codec;
    return now.codec_type == AVMEDIA_TYPE_VIDEO && now.codec_id == then.codec_id && now.width == then.width &&
           now.height == then.height && now.extradata_size == then.extradata_size;
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
        else if (m_packet->stream_index == m_analysis->stream && m_packet->size > 0)
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
               av_seek_frame(m_container.get(), m_analysis->stream, time, AVSEEK_FLAG_BACKWARD) >= 0;
    }
    return packet.position >= 0 && (flags & AVFMT_NO_BYTE_SEEK) == 0 &&
           av_seek_frame(m_container.get(), m_analysis->stream, packet.position, AVSEEK_FLAG_BYTE) >= 0;
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
