// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include <opencv2/core/mat.hpp>

#include "core/io/footage/view_source.h"

namespace core {

/// Reads a picture as 8-bit BGR, as the file has it: neither turned by its orientation tag nor scaled. Of more than 8
/// bits, `levels` says what becomes black and white; without, the bit depth that its brightest pixel needs. Throws
/// Error.
cv::Mat readImage(const std::filesystem::path& file, const std::optional<GreyLevels>& levels = std::nullopt);
/// Reads a picture as BGR of 8 or 16 bits, whichever the file has. Throws Error.
cv::Mat readRawImage(const std::filesystem::path& file);
/// Reads a mask as CV_8U, 255 where any colour of the picture is not 0, whatever its bit depth.
cv::Mat readMask(const std::filesystem::path& file);
/// Writes an 8-bit picture (1, 3 or 4 channels, BGR order) as PNG, atomically.
void writePng(const std::filesystem::path& file, const cv::Mat& image);

} // namespace core
