// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stop_token>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/io/dataset/dataset.h"
#include "core/io/dataset/frames.h"

namespace core {

/// Pictures of the cameras without hands: FOLDER/<camera>.png or .jpg, one per camera. Throws Error: NotFound naming
/// the first that is missing, BadInput for one of another size than the camera's.
std::vector<cv::Mat> readRoomPictures(const std::filesystem::path& folder, const std::vector<Camera>& cameras);

/// The same as the median of up to `samples` frames, spread over the sequence: right where hands stay for less than
/// half of the time. Empty for cameras without pictures, and where it was stopped.
std::vector<cv::Mat> medianRoomPictures(const FrameSource& source, std::size_t cameras, int samples,
                                        const std::stop_token& stop);

} // namespace core
