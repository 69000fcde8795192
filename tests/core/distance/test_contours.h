// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "core/contour/oriented_contour.h"

namespace core::testing {

/// A mask like that of two crossing hands: palms, fingers and forearms that leave holes between them and run out of the
/// image.
cv::Mat crossingHandsMask(int width, int height);

/// Its outline, boundary pixels where they are (no offset), so that points lie on the pixel grid.
OrientedContour gridContour(const cv::Mat& mask);

/// `count` points anywhere in an area larger than width x height, with random directions; some coincide.
OrientedContour randomContour(int count, int width, int height, std::uint64_t seed);

} // namespace core::testing
