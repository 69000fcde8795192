// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/io/dataset/dataset.h"
#include "core/io/footage/image_orientation.h"

namespace core {

/// How a person wants the pictures of one camera to be read.
struct PictureOptions {
    std::optional<int>
        rotateDegrees; ///< clockwise: 0, 90, 180 or 270; none: as the file's own tag says, if the result fits
    std::optional<GreyLevels> levels; ///< none: measured
    std::optional<double> scale; ///< pixels of the pictures per pixel of the calibration: 0.5 for half-size footage
    std::optional<Eigen::Vector2d> cropPx; ///< where the pictures' top left pixel lies in the calibrated image
};

/// How the pictures of one camera are to be read.
struct PictureSetup {
    Camera camera; ///< of the pictures' size; its intrinsic matrix is changed by scale and crop
    int rotateDegrees = 0;
    std::vector<FootageNote> notes; ///< what a person should know
};

/// Fits recorded pictures to a calibrated camera. `file` is named in errors. Scale and crop change the intrinsic matrix
/// (pixel centres at integers: cx' = (cx - left + 0.5) * scale - 0.5) and leave the distortion, which acts before it,
/// as it is. Throws Error(BadInput) if the sizes do not fit; it names the option that would make them fit where that
/// can be told.
PictureSetup setUpPictures(const Camera& camera, const std::string& file, ImageSize recorded, const Orientation& tag,
                           const PictureOptions& options);

/// Black and white points of pictures of more than 8 bits, measured in some of these files (those that exist);
/// empty if the first one has 8.
std::optional<GreyLevels> measureFileLevels(const std::vector<std::filesystem::path>& files);

/// What is to be said about a camera whose files ask for another orientation than they are stored in; empty if they do
/// not. `rotateDegrees`: how they are turned.
std::optional<FootageNote> orientationNote(const std::string& camera, const Orientation& tag, int rotateDegrees);

} // namespace core
