// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/dataset/dataset.h"

namespace core {

/// The video that a labelled picture was taken from, by its path: "take1" of "labeled-data/take1/img0007.png", also
/// with backslashes. Empty if the path names no folder.
std::string videoOfPicture(std::string_view path);

/// A video that belongs to a sequence.
struct VideoOfSequence {
    std::string camera; ///< whose footage it is; empty if the name does not tell
};

/// The view of the sequence, or the sequence itself, that a video's name stands for; empty for a video of something
/// else. A video belongs if it is called as the footage of a view (file without ending, or folder of the pictures), as
/// the sequence, or as the sequence with a camera's name before or after it.
std::optional<VideoOfSequence> videoOfSequence(const Dataset& dataset, const Sequence& sequence,
                                               const std::string& video);

/// The same for videos that were asked for by name, with or without a camera's name.
std::optional<VideoOfSequence> videoAskedFor(const Dataset& dataset, const Sequence& sequence, const std::string& video,
                                             const std::vector<std::string>& wanted);

} // namespace core
