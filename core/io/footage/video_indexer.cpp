// SPDX-License-Identifier: MIT
#include "core/io/footage/video_indexer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string_view>

extern "C" {
#include <libavutil/display.h>
}

#include "core/error.h"
#include "core/io/footage/frame_times.h"
#include "core/io/footage/video_decoder.h"
#include "core/io/footage/video_demuxer.h"

namespace core {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kConfirmed = 48; ///< pictures that are decoded to confirm an order by time stamps
constexpr int kFarthest = 64;          ///< pictures are not reordered further than this

bool isIntraOnly(const AVStream& stream) {
    const AVCodecDescriptor* codec = avcodec_descriptor_get(stream.codecpar->codec_id);
    return codec != nullptr && (codec->props & AV_CODEC_PROP_INTRA_ONLY) != 0;
}

/// Containers in which every packet is a picture with a time stamp of its own. Elsewhere stamps are guessed by the
/// library, or missing.
bool hasReliableTimes(const VideoDemuxer& demuxer) {
    const std::string_view container = demuxer.container().iformat->name;
    const AVCodecParameters& codec = *demuxer.stream().codecpar;
    const auto is = [&](std::string_view name) { return container.find(name) != std::string_view::npos; };
    if (container == "mpegts") { // fields may be packets of their own
        return (codec.codec_id == AV_CODEC_ID_H264 || codec.codec_id == AV_CODEC_ID_HEVC) &&
               codec.field_order <= AV_FIELD_PROGRESSIVE;
    }
    return is("mp4") || is("matroska") || is("webm") || (container != "mpeg" && isIntraOnly(demuxer.stream()));
}

/// VP8 and VP9 have packets that are decoded but not shown.
bool isShown(const AVPacket& packet, AVCodecID codec) {
    if ((packet.flags & AV_PKT_FLAG_DISCARD) != 0)
        return false; // cut away by the container's edit list
    const unsigned first = packet.data[0];
    if (codec == AV_CODEC_ID_VP8)
        return (first & 0x10) != 0;
    if (codec == AV_CODEC_ID_VP9 && first >> 6 == 2) {
        const bool isSuperframe = (packet.data[packet.size - 1] & 0xe0) == 0xc0; // one of its frames is shown
        const bool hasReservedBit = (first & 0x30) == 0x30;                      // profile 3
        const unsigned bits = hasReservedBit ? first << 1 : first;
        const bool showsExisting = (bits & 0x08) != 0;
        return isSuperframe || showsExisting || (bits & 0x02) != 0;
    }
    return true;
}

/// Pictures as packets in the order of presentation; renumbers the packets.
void setPictures(VideoIndex& index, std::vector<int> packets) {
    for (VideoPacket& packet : index.packets)
        packet.picture = -1;
    for (std::size_t picture = 0; picture < packets.size(); ++picture)
        index.packets[static_cast<std::size_t>(packets[picture])].picture = static_cast<int>(picture);
    index.packetOfPicture = std::move(packets);
}

/// All packets in the order of the file, and which of them are shown.
std::vector<int> readPackets(VideoDemuxer& demuxer, VideoIndex& index) {
    std::vector<int> shown;
    const AVCodecID codec = demuxer.stream().codecpar->codec_id;
    while (const AVPacket* packet = demuxer.next()) {
        if (isShown(*packet, codec))
            shown.push_back(static_cast<int>(index.packets.size()));
        index.packets.push_back(describe(*packet));
    }
    return shown;
}

/// Puts pictures into the order of their time stamps. False if those are not all there, not different, or jump.
bool orderByTime(VideoIndex& index, std::vector<int> shown, bool intraOnly) {
    const auto time = [&](int p) {
        const VideoPacket& packet = index.packets[static_cast<std::size_t>(p)];
        return packet.pts == VideoPacket::kNoTime && intraOnly ? packet.dts : packet.pts;
    };
    const std::vector<int> inFile = shown;
    std::sort(shown.begin(), shown.end(), [&](int a, int b) { return time(a) < time(b); });
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const auto place = std::lower_bound(inFile.begin(), inFile.end(), shown[i]) - inFile.begin();
        if (time(shown[i]) == VideoPacket::kNoTime || (i > 0 && time(shown[i]) == time(shown[i - 1])) ||
            std::abs(place - static_cast<std::ptrdiff_t>(i)) > kFarthest)
            return false;
    }
    setPictures(index, std::move(shown));
    return !index.packetOfPicture.empty();
}

/// Decodes from the start: the packets of the pictures that come, in their order. `each` sees every packet before it is
/// decoded; ends after `most` pictures.
struct Decoded {
    std::vector<int> packets;
    int errors = 0;
};
Decoded decodeFromStart(VideoDemuxer& demuxer, const std::string& file, std::size_t most, VideoIndex& index,
                        const std::function<void(const AVPacket&)>& each) {
    Decoded decoded;
    VideoDecoder decoder(demuxer.stream(), file, VideoDecoder::usualThreads());
    decoder.setQuick(); // which pictures come counts, not how they look
    int number = 0;
    for (bool ended = false; !ended && decoded.packets.size() < most;) {
        const AVPacket* packet = demuxer.next();
        ended = packet == nullptr;
        if (packet != nullptr)
            each(*packet);
        decoder.send(packet, number++);
        while (const AVFrame* picture = decoder.receive()) {
            if (decoded.packets.empty())
                index.size = {picture->width, picture->height};
            decoded.packets.push_back(VideoDecoder::packetOf(*picture));
        }
    }
    decoded.errors = decoder.errors();
    return decoded;
}

/// Decodes the beginning: are the pictures those of the index? Pictures that the decoder drops before the first key
/// picture (they lean on a group that is not in the file) leave the index.
bool confirmStart(VideoDemuxer& demuxer, const std::string& file, VideoIndex& index) {
    demuxer.rewind();
    const Decoded decoded = decodeFromStart(demuxer, file, kConfirmed, index, [](const AVPacket&) {});
    std::vector<int> pictures;
    for (const int packet : decoded.packets) {
        pictures.push_back(packet >= 0 && packet < static_cast<int>(index.packets.size())
                               ? index.packets[static_cast<std::size_t>(packet)].picture
                               : -1);
    }
    if (pictures.empty() || pictures.front() < 0)
        return false;
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        const int step = pictures[i] - pictures[i - 1];
        if (step < 1 || (step > 1 && decoded.errors == 0))
            return false;
    }
    const auto key = std::find_if(index.packets.begin(), index.packets.end(),
                                  [](const VideoPacket& packet) { return packet.isKey && packet.picture >= 0; });
    const int leading = std::min(pictures.front(), key == index.packets.end() ? 0 : key->picture);
    if (leading < pictures.front() && decoded.errors == 0)
        return false;
    setPictures(index, {index.packetOfPicture.begin() + leading, index.packetOfPicture.end()});
    return true;
}

/// Decodes everything once: the pictures are those that come.
void orderByDecoding(VideoDemuxer& demuxer, const std::string& file, VideoIndex& index) {
    demuxer.rewind();
    index.packets.clear();
    Decoded decoded = decodeFromStart(demuxer, file, SIZE_MAX, index,
                                      [&](const AVPacket& packet) { index.packets.push_back(describe(packet)); });
    if (decoded.packets.empty())
        throw Error(ErrorCode::BadInput, file, "", "not a readable video (none of its pictures can be decoded)");
    const std::set<int> different(decoded.packets.begin(), decoded.packets.end());
    index.isCounted = different.size() != decoded.packets.size() || *different.begin() < 0 ||
                      *different.rbegin() >= static_cast<int>(index.packets.size());
    if (index.isCounted)
        decoded.packets.assign(decoded.packets.size(), 0);
    setPictures(index, std::move(decoded.packets));
}

/// Presentation times: the packets' own; where some have none, those of decoding in increasing order. Empty if they do
/// not increase.
std::vector<double> timesOf(const VideoIndex& index, AVRational timeBase) {
    const auto stamps = [&](auto member) {
        std::vector<std::int64_t> times;
        for (const int p : index.packetOfPicture)
            times.push_back(index.packets[static_cast<std::size_t>(p)].*member);
        return times;
    };
    std::vector<std::int64_t> times = stamps(&VideoPacket::pts);
    if (std::find(times.begin(), times.end(), VideoPacket::kNoTime) != times.end()) {
        times = stamps(&VideoPacket::dts);
        std::sort(times.begin(), times.end());
    }
    const auto isNotLater = [](std::int64_t a, std::int64_t b) { return a >= b; };
    const bool increases = std::adjacent_find(times.begin(), times.end(), isNotLater) == times.end();
    std::vector<double> seconds;
    if (!index.isCounted && increases && times.front() != VideoPacket::kNoTime)
        for (const std::int64_t time : times)
            seconds.push_back(static_cast<double>(time) * av_q2d(timeBase));
    return seconds;
}

double rateOf(const VideoIndex& index, const AVStream& stream) {
    const FrameTiming timing = analyseTimes(index.timesSec);
    if (timing.isSane)
        return roundedRate(timing.stepSec);
    const AVRational rate = stream.avg_frame_rate.num > 0 ? stream.avg_frame_rate : stream.r_frame_rate;
    return rate.num > 0 && rate.den > 0 ? av_q2d(rate) : 0;
}

/// The container's display matrix as a clockwise turn.
int rotationOf(const AVStream& stream) {
    std::size_t size = 0;
    const std::uint8_t* matrix = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &size);
    if (matrix == nullptr || size < 9 * sizeof(std::int32_t))
        return 0;
    const double counterClockwise = av_display_rotation_get(reinterpret_cast<const std::int32_t*>(matrix));
    return std::isnan(counterClockwise) ? 0
                                        : ((static_cast<int>(std::lround(-counterClockwise / 90)) % 4 + 4) % 4) * 90;
}

} // namespace

VideoIndex indexVideo(VideoDemuxer& demuxer) {
    VideoIndex index;
    const std::string file = demuxer.file().string();
    const FileStamp stamp = stampOf(demuxer.file());
    index.fileSize = stamp.size;
    index.fileTime = stamp.time;
    const bool isOrdered = hasReliableTimes(demuxer) &&
                           orderByTime(index, readPackets(demuxer, index), isIntraOnly(demuxer.stream())) &&
                           confirmStart(demuxer, file, index);
    if (!isOrdered)
        orderByDecoding(demuxer, file, index);
    index.timesSec = timesOf(index, demuxer.stream().time_base);
    index.framesPerSecond = rateOf(index, demuxer.stream());
    index.rotationDegrees = rotationOf(demuxer.stream());
    return index;
}

} // namespace core
