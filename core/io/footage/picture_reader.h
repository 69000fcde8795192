// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/io/footage/video_decoder.h"
#include "core/io/footage/video_demuxer.h"
#include "core/io/footage/video_index.h"

namespace core {

/// Any picture of an indexed video, by its number: decoding goes on from the last one, or starts at a key packet far
/// enough before. Every packet that is read is compared with the index, and every picture is known by its packet; where
/// decoding that started in the middle does not yield what the index says, it starts further back, in the end at the
/// beginning.
/// All pictures that are decoded on the way are kept, as decoded, within a budget: those nearest to the last one that
/// was read, the side that reading goes to before the other.
class PictureReader {
public:
    /// `video` is at its first packet. `threads` decode. Throws Error(BadInput) if there is no decoder.
    PictureReader(VideoDemuxer video, std::shared_ptr<const VideoIndex> index, int threads);

    const VideoDemuxer& video() const { return m_demuxer; }

    const VideoIndex& index() const { return m_index; }
    /// How many threads decode, from the next start at a key packet on: going on never changes them.
    void setThreads(int threads) { m_threads = threads; }
    /// Sees every whole picture that is let go of for want of room.
    void setOnForgotten(std::function<void(int picture, const AVFrame& frame)> seen) {
        m_onForgotten = std::move(seen);
    }
    /// How much memory kept pictures may take; one is always kept.
    void setBudget(std::int64_t bytes);
    /// The picture, as decoded; valid until the next call; null if it was stopped, which loses nothing that is decoded.
    /// Throws Error(BadInput) if it is damaged.
    const AVFrame* read(int picture, const std::stop_token& stop = {});
    /// Decodes the nearest picture that is not kept before (direction -1) or after (+1) the last one that was read, and
    /// all that it leans on. False if there is nothing to do: all that fits the budget is kept.
    bool fetchAhead(int direction, const std::stop_token& stop);
    bool isKept(int picture) const { return m_kept.contains(picture); }
    /// How many packets must be decoded before this picture comes; 0: it is kept.
    int packetsUntil(int picture) const;
    /// How many bytes these are; they tell better how long it takes.
    std::int64_t bytesUntil(int picture) const;
    /// The kept picture nearest to this one, with its number; null if none is kept.
    const AVFrame* nearest(int picture, int& number) const;

private:
    enum class Outcome { Found, Missing, Lost, Stopped };

    const AVFrame* kept(int picture) const;
    void keep(int picture, const AVFrame& frame);
    void trim();
    int remoteness(int picture) const;
    std::optional<int> wantedAhead() const;
    const AVFrame* decode(int picture, const std::stop_token& stop);
    bool canGoOn(int picture) const;
    int nextPacketFor(int picture) const;
    void startAt(int packet);
    bool seekTo(int packet);
    void skipTo(int packet);
    Outcome advanceTo(int picture, const std::stop_token& stop);
    bool feed();
    int pictureOf(const AVFrame& frame);
    bool isPacket(const AVPacket& packet, int number) const;
    int numberOf(const AVPacket& packet) const;
    const AVFrame* searchFrom(int start, int picture, const std::stop_token& stop);

    std::shared_ptr<const VideoIndex> m_sharedIndex;
    const VideoIndex& m_index;
    VideoDemuxer m_demuxer;
    int m_threads; ///< wanted
    int m_decodingThreads;
    std::unique_ptr<VideoDecoder> m_decoder;
    std::vector<std::pair<std::uint64_t, int>> m_numberByHash; ///< sorted
    const AVPacket* m_pending = nullptr;                       ///< read, not yet decoded
    int m_nextPacket = 0;                                      ///< that the decoder will get
    int m_firstPicture = 0;                                    ///< of this run of decoding; earlier ones are not whole
    int m_lastPicture = -1;                                    ///< the highest that this run has yielded
    int m_counted = 0;                                         ///< pictures of this run
    bool m_isRunning = false;
    bool m_hasEnded = false;            ///< the decoder has been told that no packet follows
    std::map<int, FramePointer> m_kept; ///< by picture
    std::int64_t m_keptBytes = 0, m_budget;
    int m_focus = 0;     ///< the last picture that was read
    int m_direction = 1; ///< that reading goes to
    std::set<int> m_damaged;
    std::function<void(int, const AVFrame&)> m_onForgotten;
};

} // namespace core
