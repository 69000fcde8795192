// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"
#include "core/io/dataset/picture_setup.h"

namespace core {

/// Footage of one camera, as a person names it.
struct Footage {
    std::string camera;
    std::filesystem::path path;        ///< a video; a pattern of images with {frame}; or a folder of numbered images
    std::optional<int> offsetFrames{}; ///< the footage's frame at the sequence's first instant; none: its first one
    PictureOptions pictures{};         ///< how its pictures are to be read
};

/// A sequence made of footage, and what a person should know about it.
struct NewSequence {
    Sequence sequence;
    std::vector<FootageNote> notes; ///< such as: cam1 has 41 frames more than the others
    std::vector<Camera> cameras;    ///< as given; those of scaled or cropped footage fit it
};

/// How frames of videos become instants of a sequence.
enum class FootageSync {
    Automatic, ///< by time where all videos have the same rate and sound time stamps, else by number
    Index,     ///< by number: the n-th frames are of one instant
    Time       ///< by time: instants of frames that a camera lost are missing in its view
};

/// The size of the first pictures that can be read, for calibrations that hold none.
std::optional<ImageSize> footageSize(const std::vector<Footage>& footage);

/// A sequence of cameras without footage, for annotations that were made elsewhere.
Sequence sequenceWithoutFootage(const std::string& name, const std::vector<Camera>& cameras, int frameCount,
                                std::optional<double> framesPerSecond = {});

/// Looks at the footage of all cameras and makes a sequence of it: it is as long as its shortest footage. Missing
/// images, and frames that a video lost, are instants without a picture. Paths are written relative to `datasetFolder`
/// (which need not exist yet). Cameras without footage get no picture. `framesPerSecond`: that of the videos if not
/// given, else 50. Throws Error if footage is missing or unreadable, of a camera that is not there, or not of the size
/// that the camera is calibrated for (turned, scaled and cropped as `pictures` says).
NewSequence makeSequence(const std::string& name, const std::vector<Camera>& cameras,
                         const std::vector<Footage>& footage, const std::filesystem::path& datasetFolder,
                         std::optional<double> framesPerSecond = {}, FootageSync sync = FootageSync::Automatic);

} // namespace core
