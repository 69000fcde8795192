// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <opencv2/core/mat.hpp>

namespace core {

/// Reads a picture as 8-bit BGR, as the file has it: neither turned by its orientation tag nor scaled. Throws Error.
cv::Mat readImage(const std::filesystem::path& file);
/// Reads a mask as CV_8U, 255 where the picture is not black.
cv::Mat readMask(const std::filesystem::path& file);
/// Writes an 8-bit picture (1, 3 or 4 channels, BGR order) as PNG, atomically.
void writePng(const std::filesystem::path& file, const cv::Mat& image);

} // namespace core
