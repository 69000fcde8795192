// SPDX-License-Identifier: MIT
#include "core/io/footage/planes420.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/core.hpp>

namespace core {

namespace {

constexpr int kBits = 13; ///< of the matrix

/// One row of colour samples between two rows of them, times 4.
void mixRows(const std::uint8_t* __restrict near, const std::uint8_t* __restrict far, int count,
             std::int16_t* __restrict mixed) {
    for (int i = 0; i < count; ++i)
        mixed[i] = static_cast<std::int16_t>(3 * near[i] + far[i]);
}

/// Twice as many samples in a row, times 4 again, about 0: 128 is 2048.
void spreadRow(const std::int16_t* __restrict mixed, int count, std::int16_t* __restrict spread) {
    constexpr int kMiddle = 16 * 128;
    spread[0] = static_cast<std::int16_t>(4 * mixed[0] - kMiddle);
    for (int i = 0; i + 1 < count; ++i) {
        spread[2 * i + 1] = static_cast<std::int16_t>(3 * mixed[i] + mixed[i + 1] - kMiddle);
        spread[2 * i + 2] = static_cast<std::int16_t>(mixed[i] + 3 * mixed[i + 1] - kMiddle);
    }
    spread[2 * count - 1] = static_cast<std::int16_t>(4 * mixed[count - 1] - kMiddle);
}

std::uint8_t toByte(int value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

/// `u` and `v` are 16 times their values.
void toColours(const std::uint8_t* __restrict y, const std::int16_t* __restrict u, const std::int16_t* __restrict v,
               int count, const ColourMatrix m, std::uint8_t* __restrict blue, std::uint8_t* __restrict green,
               std::uint8_t* __restrict red) {
    constexpr int kShift = kBits + 4, kHalf = 1 << (kShift - 1);
    for (int x = 0; x < count; ++x) {
        const int light = m.luma * 16 * (y[x] - m.black) + kHalf;
        blue[x] = toByte((light + m.blueFromU * u[x]) >> kShift);
        green[x] = toByte((light + m.greenFromU * u[x] + m.greenFromV * v[x]) >> kShift);
        red[x] = toByte((light + m.redFromV * v[x]) >> kShift);
    }
}

} // namespace

ColourMatrix colourMatrix(const int* coefficients, bool isFullRange) {
    const double unit = double(1 << kBits) / (1 << 16), luma = isFullRange ? 1.0 : 255.0 / 219,
                 colour = isFullRange ? 224.0 / 255 : 1.0;
    const auto scaled = [&](int coefficient) { return static_cast<int>(std::lround(coefficient * unit * colour)); };
    ColourMatrix matrix;
    matrix.luma = static_cast<int>(std::lround(luma * (1 << kBits)));
    matrix.black = isFullRange ? 0 : 16;
    matrix.redFromV = scaled(coefficients[0]);
    matrix.blueFromU = scaled(coefficients[1]);
    matrix.greenFromU = -scaled(coefficients[2]);
    matrix.greenFromV = -scaled(coefficients[3]);
    return matrix;
}

cv::Mat bgrOf(const Planes420& planes, const ColourMatrix& matrix) {
    const int columns = (planes.width + 1) / 2, rows = (planes.height + 1) / 2;
    std::vector<std::int16_t> mixed(static_cast<std::size_t>(columns)), u(2 * mixed.size()), v(2 * mixed.size());
    cv::Mat bgr(planes.height, planes.width, CV_8UC3), blue(1, planes.width, CV_8U), green(1, planes.width, CV_8U),
        red(1, planes.width, CV_8U);
    const auto spread = [&](int plane, int row, std::vector<std::int16_t>& out) {
        const int near = row / 2, far = std::clamp(row % 2 == 0 ? near - 1 : near + 1, 0, rows - 1);
        const std::uint8_t* samples = planes.data[static_cast<std::size_t>(plane)];
        const std::ptrdiff_t stride = planes.stride[static_cast<std::size_t>(plane)];
        mixRows(samples + near * stride, samples + far * stride, columns, mixed.data());
        spreadRow(mixed.data(), columns, out.data());
    };
    const cv::Mat colours[] = {blue, green, red};
    for (int row = 0; row < planes.height; ++row) {
        spread(1, row, u);
        spread(2, row, v);
        toColours(planes.data[0] + row * planes.stride[0], u.data(), v.data(), planes.width, matrix, blue.data,
                  green.data, red.data);
        cv::Mat line = bgr.row(row);
        cv::merge(colours, 3, line);
    }
    return bgr;
}

} // namespace core
