// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>

#include <opencv2/core/mat.hpp>

struct AVFrame;
struct SwsContext;

namespace core {

/// Turns decoded pictures of any pixel format and depth into 8-bit BGR.
class PictureConverter {
public:
    PictureConverter();
    ~PictureConverter();

    /// CV_8UC3 of the picture's size; empty if its pixel format is not supported. Colours as the stream says; where it
    /// does not, BT.709 for pictures wider than 1024 or at least 600 pixels high, else BT.601. 8-bit 4:2:0, which
    /// nearly all video is, goes a fast way whose values differ from the library's by the rounding of interpolated
    /// colours.
    cv::Mat toBgr(const AVFrame& picture);
    /// The same at 1 / shrink of its size, rounded up, each pixel the mean of shrink x shrink; a border that is cut by
    /// the edge repeats the edge. 8-bit 4:2:0 is shrunk before it is converted: for 4, a fifth of the work.
    cv::Mat toBgr(const AVFrame& picture, int shrink);

private:
    struct Deleter {
        void operator()(SwsContext* context) const;
    };
    bool prepare(const AVFrame& picture);
    cv::Mat fromPlanes(const AVFrame& picture, int shrink);
    cv::Mat byLibrary(const AVFrame& picture);

    std::unique_ptr<SwsContext, Deleter> m_context;
    std::array<int, 5> m_prepared{}; ///< size, format, colours and range that the context is for
};

} // namespace core
