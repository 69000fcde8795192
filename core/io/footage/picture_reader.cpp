// SPDX-License-Identifier: MIT
#include "core/io/footage/picture_reader.h"

#include <algorithm>
#include <climits>
#include <iterator>

extern "C" {
#include <libavutil/imgutils.h>
}

#include "core/error.h"

namespace core {

namespace {

constexpr std::int64_t kUsualBudget = 24 << 20; ///< bytes of decoded pictures
constexpr int kLate = 16;                       ///< a picture does not come this many pictures late
constexpr int kNear = 8;                        ///< packets: decoding on is cheaper than seeking
constexpr int kStrange = 64;                    ///< packets that are not in the index, after a seek

std::int64_t bytesOf(const AVFrame& frame) {
    return std::max(0,
                    av_image_get_buffer_size(static_cast<AVPixelFormat>(frame.format), frame.width, frame.height, 1));
}

/// Whether decoding may start with this picture: nothing before it is needed.
bool isEntry(const AVFrame& frame) {
    return frame.key_frame != 0 || frame.pict_type == AV_PICTURE_TYPE_I;
}

} // namespace

PictureReader::PictureReader(VideoDemuxer video, std::shared_ptr<const VideoIndex> index, int threads)
    : m_sharedIndex(std::move(index))
    , m_index(*m_sharedIndex)
    , m_demuxer(std::move(video))
    , m_threads(threads)
    , m_decodingThreads(threads)
    , m_decoder(std::make_unique<VideoDecoder>(m_demuxer.stream(), m_demuxer.file().string(), threads))
    , m_budget(kUsualBudget) {
    for (std::size_t p = 0; p < m_index.packets.size(); ++p)
        m_numberByHash.emplace_back(m_index.packets[p].hash, static_cast<int>(p));
    std::sort(m_numberByHash.begin(), m_numberByHash.end());
    m_isRunning = true; // at the first packet
}

void PictureReader::setBudget(std::int64_t bytes) {
    m_budget = bytes;
    trim();
}

const AVFrame* PictureReader::read(int picture, const std::stop_token& stop) {
    if (picture != m_focus)
        m_direction = picture < m_focus ? -1 : 1;
    m_focus = picture;
    return decode(picture, stop);
}

const AVFrame* PictureReader::decode(int picture, const std::stop_token& stop) {
    const AVFrame* frame = kept(picture);
    const bool isKnownDamaged = m_damaged.contains(picture);
    if (frame == nullptr && !isKnownDamaged && canGoOn(picture) && advanceTo(picture, stop) == Outcome::Found)
        frame = kept(picture);
    if (frame != nullptr && !VideoDecoder::isDamaged(*frame))
        return frame;
    if (!isKnownDamaged && !stop.stop_requested())
        frame = searchFrom(m_index.startFor(picture, INT_MAX), picture, stop);
    if (frame != nullptr && !VideoDecoder::isDamaged(*frame))
        return frame;
    if (!isKnownDamaged && stop.stop_requested())
        return nullptr;
    m_damaged.insert(picture);
    throw Error(ErrorCode::BadInput, m_demuxer.file().string(), "frame " + std::to_string(picture),
                "the picture is damaged and cannot be decoded");
}

/// Starts at `start`, then further and further back. Null if the picture does not come whole.
const AVFrame* PictureReader::searchFrom(int start, int picture, const std::stop_token& stop) {
    int damaged = 0;
    for (int back = 1;; back *= 4) {
        startAt(start);
        const Outcome outcome = advanceTo(picture, stop);
        const AVFrame* frame = outcome == Outcome::Found ? kept(picture) : nullptr;
        if (outcome == Outcome::Stopped || (frame != nullptr && !VideoDecoder::isDamaged(*frame)))
            return frame;
        damaged += frame != nullptr || (outcome == Outcome::Missing && m_decoder->errors() > 0) ? 1 : 0;
        if (start == 0 || damaged == 2)
            return nullptr;
        for (int i = 0; i < back && start > 0; ++i)
            start = back > 4 ? 0 : m_index.startFor(picture, start - 1);
    }
}

bool PictureReader::fetchAhead(int direction, const std::stop_token& stop) {
    m_direction = direction;
    const std::optional<int> picture = wantedAhead();
    if (!picture || stop.stop_requested())
        return false;
    try {
        decode(*picture, stop);
    } catch (const Error&) { // it is thrown again when the picture is asked for
    }
    return !stop.stop_requested();
}

/// How little a picture is wanted: its distance from the last one that was read; those behind are wanted less.
int PictureReader::remoteness(int picture) const {
    constexpr int kBehind = 3;
    const int ahead = (picture - m_focus) * m_direction;
    return ahead >= 0 ? ahead : -kBehind * ahead;
}

/// The nearest picture ahead that is not kept, if keeping it is worth the work. Going back, whole groups are decoded
/// for it: the cache is filled again only when half of it is used up.
std::optional<int> PictureReader::wantedAhead() const {
    int picture = m_focus + m_direction;
    while (m_kept.contains(picture) || m_damaged.contains(picture))
        picture += m_direction;
    if (picture < 0 || picture >= m_index.pictures() || m_kept.empty())
        return std::nullopt;
    const std::int64_t each = m_keptBytes / static_cast<std::int64_t>(m_kept.size());
    if (m_keptBytes + each <= m_budget)
        return picture;
    const int distance = remoteness(picture), count = static_cast<int>(m_kept.size());
    const int most = std::max(remoteness(m_kept.begin()->first), remoteness(m_kept.rbegin()->first));
    const bool isWorthIt = distance < most && (m_direction > 0 || distance <= count / 2);
    return isWorthIt ? std::optional(picture) : std::nullopt;
}

const AVFrame* PictureReader::kept(int picture) const {
    const auto found = m_kept.find(picture);
    return found == m_kept.end() ? nullptr : found->second.get();
}

int PictureReader::packetsUntil(int picture) const {
    if (kept(picture) != nullptr)
        return 0;
    const int last = m_index.packetOfPicture[static_cast<std::size_t>(picture)];
    return std::max(1, last + 1 - nextPacketFor(picture));
}

std::int64_t PictureReader::bytesUntil(int picture) const {
    std::int64_t bytes = 0;
    if (kept(picture) == nullptr)
        for (int p = nextPacketFor(picture); p <= m_index.packetOfPicture[static_cast<std::size_t>(picture)]; ++p)
            bytes += m_index.packets[static_cast<std::size_t>(p)].size;
    return bytes;
}

/// Which packet is decoded next if this picture is wanted.
int PictureReader::nextPacketFor(int picture) const {
    return canGoOn(picture) ? m_nextPacket : m_index.startFor(picture, INT_MAX);
}

const AVFrame* PictureReader::nearest(int picture, int& number) const {
    auto best = m_kept.lower_bound(picture);
    if (best != m_kept.begin() && (best == m_kept.end() || picture - std::prev(best)->first <= best->first - picture))
        best = std::prev(best);
    if (best == m_kept.end())
        return nullptr;
    number = best->first;
    return best->second.get();
}

void PictureReader::keep(int picture, const AVFrame& frame) {
    FramePointer& place = m_kept[picture];
    m_keptBytes -= place ? bytesOf(*place) : 0; // perhaps from a worse start
    place.reset(av_frame_clone(&frame));
    m_keptBytes += bytesOf(frame);
    trim();
}

/// Lets go of the least wanted pictures.
void PictureReader::trim() {
    while (m_keptBytes > m_budget && m_kept.size() > 1) {
        const auto first = m_kept.begin(), last = std::prev(m_kept.end());
        const auto least = remoteness(first->first) > remoteness(last->first) ? first : last;
        m_keptBytes -= bytesOf(*least->second);
        if (m_onForgotten && !VideoDecoder::isDamaged(*least->second))
            m_onForgotten(least->first, *least->second);
        m_kept.erase(least);
    }
}

bool PictureReader::canGoOn(int picture) const {
    return m_isRunning && picture > m_lastPicture && picture >= m_firstPicture &&
           m_index.startFor(picture, INT_MAX) <= m_nextPacket + kNear;
}

void PictureReader::startAt(int packet) {
    if (m_threads == m_decodingThreads) {
        m_decoder->restart();
    } else {
        m_decoder = std::make_unique<VideoDecoder>(m_demuxer.stream(), m_demuxer.file().string(), m_threads);
        m_decodingThreads = m_threads;
    }
    m_firstPicture = packet == 0 ? 0 : m_index.packets[static_cast<std::size_t>(packet)].picture;
    m_lastPicture = -1;
    m_counted = 0;
    m_hasEnded = false;
    m_isRunning = true;
    if (packet == 0 || !seekTo(packet)) {
        m_pending = nullptr;
        m_isRunning = false; // if the file has gone
        m_demuxer.rewind();
        m_isRunning = true;
        m_nextPacket = 0;
        skipTo(packet);
    }
}

/// Brings that packet next, by the container's own means. False if they do not lead there.
bool PictureReader::seekTo(int packet) {
    int target = packet;
    for (int attempt = 0; attempt < 3 && target > 0; ++attempt) {
        if (!m_demuxer.seekNear(m_index.packets[static_cast<std::size_t>(target)]))
            return false;
        for (int strange = 0; strange < kStrange; ++strange) {
            m_pending = m_demuxer.next();
            m_nextPacket = m_pending == nullptr ? -1 : numberOf(*m_pending);
            if (m_pending == nullptr || m_nextPacket >= 0)
                break;
        }
        if (m_pending != nullptr && m_nextPacket >= 0 && m_nextPacket <= packet) {
            skipTo(packet);
            return m_isRunning;
        }
        target = m_index.startFor(m_index.packets[static_cast<std::size_t>(target)].picture, target - 1);
    }
    return false;
}

/// Reads on until that packet comes next, decoding nothing.
void PictureReader::skipTo(int packet) {
    while (m_nextPacket < packet && m_isRunning) {
        const AVPacket* skipped = m_pending != nullptr ? m_pending : m_demuxer.next();
        m_pending = nullptr;
        m_isRunning = skipped != nullptr && isPacket(*skipped, m_nextPacket);
        ++m_nextPacket;
    }
}

PictureReader::Outcome PictureReader::advanceTo(int picture, const std::stop_token& stop) {
    while (m_isRunning) {
        if (stop.stop_requested())
            return Outcome::Stopped;
        while (const AVFrame* frame = m_decoder->receive()) {
            const int number = pictureOf(*frame);
            if (number < m_firstPicture)
                continue; // leans on pictures before the start, or is not shown
            if (m_firstPicture > 0 && m_lastPicture < 0 && (number != m_firstPicture || !isEntry(*frame))) {
                m_isRunning = false; // no good place to start
                return Outcome::Lost;
            }
            m_lastPicture = std::max(m_lastPicture, number);
            keep(number, *frame);
            if (number == picture)
                return Outcome::Found;
            if (number > picture + kLate)
                return Outcome::Missing;
        }
        if (m_hasEnded) {
            m_isRunning = false;
            return Outcome::Missing;
        }
        m_isRunning = feed();
    }
    return Outcome::Lost;
}

/// Gives the decoder its next packet. False if that is not the one of the index.
bool PictureReader::feed() {
    const AVPacket* packet = m_pending != nullptr ? m_pending : m_demuxer.next();
    m_pending = nullptr;
    if (packet != nullptr && !isPacket(*packet, m_nextPacket))
        return false;
    m_hasEnded = packet == nullptr;
    m_decoder->send(packet, m_nextPacket++);
    return true;
}

int PictureReader::pictureOf(const AVFrame& frame) {
    const int packet = VideoDecoder::packetOf(frame);
    if (m_index.isCounted)
        return m_counted++;
    return packet >= 0 && packet < static_cast<int>(m_index.packets.size())
               ? m_index.packets[static_cast<std::size_t>(packet)].picture
               : -1;
}

bool PictureReader::isPacket(const AVPacket& packet, int number) const {
    if (number >= static_cast<int>(m_index.packets.size()))
        return false;
    const VideoPacket& wanted = m_index.packets[static_cast<std::size_t>(number)];
    return wanted.size == static_cast<std::uint32_t>(packet.size) && wanted.hash == describe(packet).hash;
}

/// Where a packet stands in the index, by its content and, if that is there several times, its place in the file. -1 =
/// unknown.
int PictureReader::numberOf(const AVPacket& packet) const {
    const VideoPacket sought = describe(packet);
    std::vector<int> same, there;
    for (auto at = std::lower_bound(m_numberByHash.begin(), m_numberByHash.end(), std::pair(sought.hash, 0));
         at != m_numberByHash.end() && at->first == sought.hash; ++at) {
        same.push_back(at->second);
        if (m_index.packets[static_cast<std::size_t>(at->second)].position == sought.position)
            there.push_back(at->second);
    }
    const std::vector<int>& found = same.size() == 1 ? same : there;
    return found.size() == 1 ? found.front() : -1;
}

} // namespace core
