// SPDX-License-Identifier: MIT
#include "core/io/footage/key_pictures.h"

#include <climits>
#include <cstdlib>

#include "core/error.h"

namespace core {

namespace {

constexpr int kMostSkipped = 64; ///< packets between where a container leads and the one that is sought

} // namespace

KeyPictures::KeyPictures(const VideoDemuxer& video, std::shared_ptr<const VideoIndex> index)
    : m_video(video)
    , m_index(std::move(index)) {}

std::optional<int> KeyPictures::nearest(int picture) const {
    if (m_index->isCounted || m_index->packets.empty())
        return std::nullopt;
    std::optional<int> best;
    const int start = m_index->packetOfPicture[static_cast<std::size_t>(picture)];
    for (const int step : {-1, 1}) {
        for (int p = start; p >= 0 && p < static_cast<int>(m_index->packets.size()); p += step) {
            const VideoPacket& packet = m_index->packets[static_cast<std::size_t>(p)];
            if (!packet.isKey || packet.picture < 0)
                continue;
            if (!best || std::abs(packet.picture - picture) < std::abs(*best - picture))
                best = packet.picture;
            break;
        }
    }
    return best;
}

bool KeyPictures::open() {
    if (m_demuxer || !m_isUsable)
        return m_isUsable;
    try {
        m_demuxer = std::make_unique<VideoDemuxer>(m_video.another());
        m_decoder = std::make_unique<VideoDecoder>(m_demuxer->stream(), m_demuxer->file().string());
        m_decoder->setQuick();
    } catch (const Error&) { // it is thrown again when a picture is read
        m_isUsable = false;
    }
    return m_isUsable;
}

/// Brings that packet next.
bool KeyPictures::goTo(int packet) {
    const VideoPacket& sought = m_index->packets[static_cast<std::size_t>(packet)];
    if (!m_demuxer->seekNear(sought))
        return false;
    for (int read = 0; read < kMostSkipped; ++read) {
        m_packet = m_demuxer->next();
        if (m_packet == nullptr)
            return false;
        if (static_cast<std::uint32_t>(m_packet->size) == sought.size && describe(*m_packet).hash == sought.hash)
            return true;
    }
    return false;
}

const AVFrame* KeyPictures::read(int keyPicture) {
    const int packet = m_index->packetOfPicture[static_cast<std::size_t>(keyPicture)];
    if (!open() || !goTo(packet))
        return nullptr;
    m_decoder->restart();
    m_decoder->send(m_packet, packet);
    m_decoder->send(nullptr, -1);
    const AVFrame* picture = m_decoder->receive();
    const bool isWhole = picture != nullptr && VideoDecoder::packetOf(*picture) == packet &&
                         !VideoDecoder::isDamaged(*picture) && m_decoder->errors() == 0;
    return isWhole ? picture : nullptr;
}

} // namespace core
