// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "core/io/footage/video_decoder.h"
#include "core/io/footage/video_demuxer.h"
#include "core/io/footage/video_index.h"

namespace core {

/// Key pictures of an indexed video, each decoded by itself: something near a picture can be shown at once, while
/// decoding that picture takes long. For looking only: edges between blocks are not smoothed. The file is opened at the
/// first use.
class KeyPictures {
public:
    /// `video` tells what to open, and outlives this object.
    KeyPictures(const VideoDemuxer& video, std::shared_ptr<const VideoIndex> index);

    /// The number of the key picture nearest to this one. No value if none can be told.
    std::optional<int> nearest(int picture) const;
    /// That key picture, valid until the next call; null if the container does not lead there or it is damaged.
    const AVFrame* read(int keyPicture);

private:
    bool open();
    bool goTo(int packet);

    const VideoDemuxer& m_video;
    std::shared_ptr<const VideoIndex> m_index;
    std::unique_ptr<VideoDemuxer> m_demuxer;
    std::unique_ptr<VideoDecoder> m_decoder;
    const AVPacket* m_packet = nullptr; ///< where the demuxer is
    bool m_isUsable = true;
};

} // namespace core
