// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <stop_token>

#include "core/io/footage/picture_converter.h"
#include "core/io/footage/picture_reader.h"
#include "core/io/footage/small_pictures.h"

namespace core {

/// Decodes a video once, from where someone is looking outwards, and keeps all of its pictures small, so that a jump
/// can show the wanted one at once. Opens the video at the first step and lets go of it when nothing is left to do.
class PictureSurvey {
public:
    /// `video` tells what to open, and outlives this object.
    PictureSurvey(const VideoDemuxer& video, std::shared_ptr<const VideoIndex> index);

    /// Decodes the nearest picture to `focus` from `first` to `last` that `pictures` lacks, and all that it leans on;
    /// all of these are kept. False if there is none, no room for it, no need of it, or it was stopped, which loses
    /// nothing that is decoded.
    bool step(SmallPictures& pictures, int focus, int first, int last, const std::stop_token& stop);

private:
    std::optional<int> next(const SmallPictures& pictures, int focus, int first, int last) const;
    bool isWanted(const SmallPictures& pictures, int picture) const;
    bool isWorthIt() const;

    const VideoDemuxer& m_video;
    std::shared_ptr<const VideoIndex> m_index;
    std::unique_ptr<PictureReader> m_reader;
    PictureConverter m_converter;
    int m_last = -1; ///< that was decoded
    std::set<int> m_damaged;
};

} // namespace core
