// SPDX-License-Identifier: MIT
#include "core/io/footage/picture_converter.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/io/footage/planes420.h"

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace core {

namespace {

/// Libav takes numbers out of files as they are: they may be none of the enumeration's, and must not be read as such.
template <typename Enumeration>
int numberOf(const Enumeration& value) {
    int number = 0;
    static_assert(sizeof number == sizeof value);
    std::memcpy(&number, &value, sizeof number);
    return number;
}

int colourSpace(const AVFrame& picture) {
    const int space = numberOf(picture.colorspace);
    if (space != AVCOL_SPC_UNSPECIFIED && space >= 0 && space < AVCOL_SPC_NB)
        return space; // the library's table has the same numbers
    return picture.width > 1024 || picture.height >= 600 ? SWS_CS_ITU709 : SWS_CS_ITU601;
}

/// Grey and RGB pictures, and those of JPEG, use all values; video as a rule does not.
bool isFullRange(const AVFrame& picture) {
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(picture.format));
    const bool isYuv = (format->flags & AV_PIX_FMT_FLAG_RGB) == 0 && format->nb_components >= 3;
    const bool isJpeg = std::string_view(format->name).starts_with("yuvj");
    const int range = numberOf(picture.color_range);
    return isYuv ? isJpeg || range == AVCOL_RANGE_JPEG : range != AVCOL_RANGE_MPEG;
}

int shrunk(int length, int shrink) {
    return (length + shrink - 1) / shrink;
}

bool isPlain420(const AVFrame& picture) {
    return (picture.format == AV_PIX_FMT_YUV420P || picture.format == AV_PIX_FMT_YUVJ420P) && picture.width >= 2 &&
           picture.height >= 2;
}

/// Means of shrink x shrink samples, so many that `size` is filled: beyond the edge the last samples are repeated.
cv::Mat shrunkTo(cv::Size size, const cv::Mat& samples, int shrink) {
    const int right = size.width * shrink - samples.cols, below = size.height * shrink - samples.rows;
    cv::Mat whole = samples, result;
    if (right > 0 || below > 0)
        cv::copyMakeBorder(samples, whole, 0, std::max(0, below), 0, std::max(0, right), cv::BORDER_REPLICATE);
    cv::resize(whole, result, size, 0, 0, cv::INTER_AREA);
    return result;
}

} // namespace

void PictureConverter::Deleter::operator()(SwsContext* context) const {
    sws_freeContext(context);
}

PictureConverter::PictureConverter() = default;
PictureConverter::~PictureConverter() = default;

/// Makes the context for pictures of this kind, unless it is there.
bool PictureConverter::prepare(const AVFrame& picture) {
    const std::array<int, 5> wanted{picture.width, picture.height, picture.format, colourSpace(picture),
                                    isFullRange(picture) ? 1 : 0};
    if (m_context && wanted == m_prepared)
        return true;
    const int flags = SWS_BICUBIC | SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP | SWS_ACCURATE_RND;
    m_context.reset(sws_getContext(picture.width, picture.height, static_cast<AVPixelFormat>(picture.format),
                                   picture.width, picture.height, AV_PIX_FMT_BGR24, flags, nullptr, nullptr, nullptr));
    m_prepared = wanted;
    if (m_context) {
        const int* coefficients = sws_getCoefficients(colourSpace(picture));
        sws_setColorspaceDetails(m_context.get(), coefficients, isFullRange(picture) ? 1 : 0, coefficients, 1, 0,
                                 1 << 16, 1 << 16);
    }
    return m_context != nullptr;
}

cv::Mat PictureConverter::toBgr(const AVFrame& picture) {
    return isPlain420(picture) ? fromPlanes(picture, 1) : byLibrary(picture);
}

cv::Mat PictureConverter::toBgr(const AVFrame& picture, int shrink) {
    if (shrink <= 1)
        return toBgr(picture);
    const cv::Size size(shrunk(picture.width, shrink), shrunk(picture.height, shrink));
    if (isPlain420(picture) && size.width >= 2 && size.height >= 2 && picture.linesize[0] > 0)
        return fromPlanes(picture, shrink);
    const cv::Mat whole = byLibrary(picture);
    return whole.empty() ? whole : shrunkTo(size, whole, shrink);
}

cv::Mat PictureConverter::fromPlanes(const AVFrame& picture, int shrink) {
    Planes420 planes;
    planes.width = shrunk(picture.width, shrink);
    planes.height = shrunk(picture.height, shrink);
    std::array<cv::Mat, 3> smaller;
    for (std::size_t i = 0; i < 3; ++i) {
        const int half = i == 0 ? 1 : 2; // colours have half as many samples
        planes.data[i] = picture.data[i];
        planes.stride[i] = picture.linesize[i];
        if (shrink == 1)
            continue;
        const cv::Mat samples(shrunk(picture.height, half), shrunk(picture.width, half), CV_8U, picture.data[i],
                              static_cast<std::size_t>(picture.linesize[i]));
        smaller[i] = shrunkTo({shrunk(planes.width, half), shrunk(planes.height, half)}, samples, shrink);
        planes.data[i] = smaller[i].data;
        planes.stride[i] = static_cast<std::ptrdiff_t>(smaller[i].step);
    }
    return bgrOf(planes, colourMatrix(sws_getCoefficients(colourSpace(picture)), isFullRange(picture)));
}

cv::Mat PictureConverter::byLibrary(const AVFrame& picture) {
    if (!prepare(picture))
        return {};
    // The library writes whole vectors: rows are longer than the picture.
    cv::Mat wide(picture.height + 1, cv::alignSize(picture.width, 64) + 64, CV_8UC3);
    std::uint8_t* const planes[] = {wide.data, nullptr, nullptr, nullptr};
    const int strides[] = {static_cast<int>(wide.step), 0, 0, 0};
    if (sws_scale(m_context.get(), picture.data, picture.linesize, 0, picture.height, planes, strides) <= 0)
        return {};
    return wide(cv::Rect(0, 0, picture.width, picture.height)).clone();
}

} // namespace core
