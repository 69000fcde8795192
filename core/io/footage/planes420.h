// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <opencv2/core/mat.hpp>

namespace core {

/// The planes of a picture with 8 bits per sample and a colour sample for every two by two pixels (4:2:0).
struct Planes420 {
    std::array<const std::uint8_t*, 3> data{}; ///< Y, U, V
    std::array<std::ptrdiff_t, 3> stride{};    ///< bytes from row to row
    int width = 0, height = 0;                 ///< of Y; U and V have half, rounded up
};

/// How colours follow from Y, U and V, in 1 / 8192: R = luma (Y - black) + redFromV (V - 128), and so on.
struct ColourMatrix {
    int luma = 8192, black = 0;
    int redFromV = 0, greenFromU = 0, greenFromV = 0, blueFromU = 0;
};

/// `coefficients`: red from V, blue from U, minus green from U, minus green from V, in 1 / 65536, for values from 16 to
/// 235 and 16 to 240 (as libswscale has them in its tables).
ColourMatrix colourMatrix(const int* coefficients, bool isFullRange);

/// CV_8UC3 BGR. Colour samples lie in the middle of their four pixels and are interpolated linearly.
cv::Mat bgrOf(const Planes420& planes, const ColourMatrix& matrix);

} // namespace core
