// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"
#include "core/io/footage/frame_times.h"
#include "core/io/footage/image_orientation.h"

namespace core {

/// What the footage of one camera holds.
struct MeasuredFootage {
    ViewKind kind = ViewKind::Video;
    std::string path;           ///< video or pattern, as given
    ImageSize size;             ///< as recorded
    double framesPerSecond = 0; ///< 0 = unknown
    Orientation orientation{};  ///< as the file's tag says
    int frames = 0;             ///< of a video
    FrameTiming timing{};       ///< of a video
    std::vector<int> numbers{}; ///< of images, increasing; never empty
};

/// Throws Error if there is none or it cannot be read. `indexFile` as for VideoFile.
MeasuredFootage measureVideo(const std::filesystem::path& file, const std::filesystem::path& indexFile = {});
MeasuredFootage measureImages(const std::string& pattern, const std::string& camera);

/// Where the index of a view's video is kept.
std::filesystem::path videoIndexFile(const std::filesystem::path& datasetFolder, const std::string& sequence,
                                     const std::string& camera);

/// Footage laid out on a sequence's instants.
struct FootageLayout {
    int instants = 0;                  ///< from the first one to the footage's last picture
    std::vector<InstantRange> missing; ///< of them
};
/// `first`: the footage's frame, or the image's number, at the first instant. `byTime`: a video's lost frames are
/// missing instants.
FootageLayout layOut(const MeasuredFootage& footage, int first, bool byTime);
/// The ranges within the first `count` instants.
std::vector<InstantRange> within(const std::vector<InstantRange>& ranges, int count);

/// Why the videos among the footage cannot be mapped to instants by time: uneven stamps, or different rates. Empty if
/// they can.
std::string timeProblem(const std::map<std::string, MeasuredFootage>& measured);

} // namespace core
