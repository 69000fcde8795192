// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <set>
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
class PictureReader {
public:
    /// Throws Error(BadInput) if the video cannot be opened.
    PictureReader(std::filesystem::path file, VideoIndex index);

    const VideoIndex& index() const { return m_index; }
    /// The picture, as decoded; valid until the next call. Throws Error(BadInput) if it is damaged.
    const AVFrame& read(int picture);

private:
    enum class Outcome { Found, Missing, Lost };
    struct Kept {
        int picture = -1;
        FramePointer frame;
    };

    const AVFrame* kept(int picture) const;
    void keep(int picture, const AVFrame& frame);
    bool canGoOn(int picture) const;
    void startAt(int packet);
    bool seekTo(int packet);
    void skipTo(int packet);
    Outcome advanceTo(int picture);
    bool feed();
    int pictureOf(const AVFrame& frame);
    bool isPacket(const AVPacket& packet, int number) const;
    int numberOf(const AVPacket& packet) const;
    const AVFrame* searchFrom(int start, int picture);

    std::filesystem::path m_file;
    VideoIndex m_index;
    VideoDemuxer m_demuxer;
    VideoDecoder m_decoder;
    std::vector<std::pair<std::uint64_t, int>> m_numberByHash; ///< sorted
    const AVPacket* m_pending = nullptr;                       ///< read, not yet decoded
    int m_nextPacket = 0;                                      ///< that the decoder will get
    int m_firstPicture = 0;                                    ///< of this run of decoding; earlier ones are not whole
    int m_lastPicture = -1;                                    ///< the highest that this run has yielded
    int m_counted = 0;                                         ///< pictures of this run
    bool m_isRunning = false;
    bool m_hasEnded = false; ///< the decoder has been told that no packet follows
    std::deque<Kept> m_kept;
    std::int64_t m_keptBytes = 0;
    std::set<int> m_damaged;
};

} // namespace core
