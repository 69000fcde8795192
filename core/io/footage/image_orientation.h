// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/geometry/camera.h"

namespace core {

/// How a picture's orientation tag asks to be shown.
struct Orientation {
    int rotateDegrees = 0;   ///< clockwise: 0, 90, 180 or 270
    bool isMirrored = false; ///< left and right are to be exchanged, too
};

/// The EXIF orientation of a JPEG, TIFF, PNG or WebP file's bytes; no turn if there is none or it makes no sense.
Orientation orientationOf(std::string_view bytes);
/// The same for a file. Throws Error if it cannot be read.
Orientation readOrientation(const std::filesystem::path& file);

/// The size of a picture that is turned by that many degrees.
ImageSize turnedSize(ImageSize size, int rotateDegrees);

/// "640 x 480"
std::string sizeText(ImageSize size);

} // namespace core
