// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace core {

/// Where the pictures of one camera come from.
enum class ViewKind {
    None,     ///< no picture: a plain backdrop
    Rendered, ///< drawn from the recorded motion by the core's rasteriser
    Images,   ///< one image file per frame, `path` with {frame} or {frame:06}
    Video ///< a video file; instant i of the sequence is its frame i + offsetFrames, less the instants missing before i
};

/// Consecutive instants of a sequence.
struct InstantRange {
    int first = 0;
    int count = 1;
    bool operator==(const InstantRange&) const = default;
};

/// The raw levels of a picture of more than 8 bits that are shown black and white.
struct GreyLevels {
    int black = 0;
    int white = 65535; ///< above black
    bool operator==(const GreyLevels&) const = default;
};

struct ViewSource {
    std::string camera;
    ViewKind kind = ViewKind::Rendered;
    std::string path;     ///< relative to the dataset's folder
    int offsetFrames = 0; ///< frame of the video, or number of the image, at the sequence's first instant
    /// Instants without a picture in this view, increasing and apart. A video's next frame belongs to the instant after
    /// them; an image's number stays offsetFrames + instant.
    std::vector<InstantRange> missing{};
    int rotateDegrees = 0; ///< how far the recorded pictures are turned clockwise: 0, 90, 180 or 270
    std::optional<GreyLevels> levels =
        std::nullopt;       ///< of pictures of more than 8 bits; none: by the bit depth of the first one
    std::string masks = {}; ///< mask pattern of this view alone; empty: the sequence's
    int masksOffset = 0;    ///< number in the mask's file name at the sequence's first instant
};

} // namespace core
