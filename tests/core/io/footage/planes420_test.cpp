// SPDX-License-Identifier: MIT
#include "core/io/footage/planes420.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace {

struct Picture {
    Picture(int w, int h)
        : width(w)
        , height(h) {
        std::mt19937 random(static_cast<unsigned>(w * 1000 + h));
        for (int plane = 0; plane < 3; ++plane) {
            const int columns = plane == 0 ? w : (w + 1) / 2, rows = plane == 0 ? h : (h + 1) / 2;
            samples[plane].create(rows, columns + 5, CV_8U); // rows are longer than the picture
            for (int i = 0; i < rows * (columns + 5); ++i)
                samples[plane].data[i] = static_cast<std::uint8_t>(random());
        }
    }
    core::Planes420 planes() const {
        core::Planes420 result{{}, {}, width, height};
        for (std::size_t i = 0; i < 3; ++i) {
            result.data[i] = samples[i].data;
            result.stride[i] = static_cast<std::ptrdiff_t>(samples[i].step);
        }
        return result;
    }
    /// A colour sample at a pixel, interpolated between the four nearest.
    double colour(int plane, int x, int y) const {
        const int columns = (width + 1) / 2, rows = (height + 1) / 2;
        const double u = std::clamp((x - 0.5) / 2, 0.0, columns - 1.0), v = std::clamp((y - 0.5) / 2, 0.0, rows - 1.0);
        const int left = static_cast<int>(u), top = static_cast<int>(v), right = std::min(left + 1, columns - 1),
                  bottom = std::min(top + 1, rows - 1);
        const cv::Mat& s = samples[plane];
        const double across = u - left, down = v - top;
        return (1 - down) * ((1 - across) * s.at<std::uint8_t>(top, left) + across * s.at<std::uint8_t>(top, right)) +
               down * ((1 - across) * s.at<std::uint8_t>(bottom, left) + across * s.at<std::uint8_t>(bottom, right));
    }
    int width, height;
    cv::Mat samples[3];
};

TEST(Planes420, BecomeColoursAsTheStandardSays) {
    constexpr int kBt709[] = {117489, 138438, 13975, 34925}; // ITU-R BT.709, in 1 / 65536
    for (const auto& [width, height] : {std::pair(64, 48), {7, 5}, {2, 2}, {33, 4}}) {
        for (const bool isFull : {false, true}) {
            const Picture picture(width, height);
            const cv::Mat bgr = core::bgrOf(picture.planes(), core::colourMatrix(kBt709, isFull));
            ASSERT_EQ(bgr.size(), cv::Size(width, height));
            double most = 0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const double luma = picture.samples[0].at<std::uint8_t>(y, x);
                    const double light = isFull ? luma : (luma - 16) * 255 / 219, range = isFull ? 1 : 255.0 / 224;
                    const double u = (picture.colour(1, x, y) - 128) * range,
                                 v = (picture.colour(2, x, y) - 128) * range;
                    const double wanted[] = {light + 1.8556 * u, light - 0.1873 * u - 0.4681 * v, light + 1.5748 * v};
                    for (int i = 0; i < 3; ++i)
                        most = std::max(most, std::abs(std::clamp(wanted[i], 0.0, 255.0) - bgr.at<cv::Vec3b>(y, x)[i]));
                }
            }
            EXPECT_LT(most, 0.75) << width << " x " << height << (isFull ? ", full range" : "");
        }
    }
}

} // namespace
