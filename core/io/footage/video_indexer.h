// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/footage/video_demuxer.h"
#include "core/io/footage/video_index.h"

namespace core {

/// Looks through a whole video for its pictures. Where the container's time stamps can be relied on, its packets are
/// read and the first pictures decoded; else every picture is decoded once. `demuxer` is at its first packet, and
/// anywhere afterwards. Throws Error(BadInput) if it is not a readable video.
VideoIndex indexVideo(VideoDemuxer& demuxer);

} // namespace core
