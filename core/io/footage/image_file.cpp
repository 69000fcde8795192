// SPDX-License-Identifier: MIT
#include "core/io/footage/image_file.h"

#include <algorithm>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/error.h"
#include "core/io/files/atomic_file.h"
#include "core/io/files/text_file.h"
#include "core/io/footage/grey_levels.h"

namespace core {

namespace {

cv::Mat decode(const std::filesystem::path& file, int flags) {
    const std::string content = readTextFile(file);
    const std::vector<uchar> bytes(content.begin(), content.end());
    cv::Mat image;
    try {
        image = bytes.empty() ? cv::Mat() : cv::imdecode(bytes, flags | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) {
        image.release(); // said below
    }
    if (image.empty())
        throw Error(ErrorCode::BadInput, file.string(), "", "is not a readable picture");
    return image;
}

} // namespace

cv::Mat readRawImage(const std::filesystem::path& file) {
    const cv::Mat image = decode(file, cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH);
    return image.depth() == CV_8U || image.depth() == CV_16U ? image : decode(file, cv::IMREAD_COLOR);
}

cv::Mat readImage(const std::filesystem::path& file, const std::optional<GreyLevels>& levels) {
    const cv::Mat image = readRawImage(file);
    return image.depth() == CV_16U ? toEightBits(image, levels ? *levels : levelsByDepth(image)) : image;
}

cv::Mat readMask(const std::filesystem::path& file) {
    const cv::Mat image = decode(file, cv::IMREAD_UNCHANGED);
    std::vector<cv::Mat> channels;
    cv::split(image, channels);
    cv::Mat mask = channels.front() != 0;
    for (std::size_t c = 1; c < std::min<std::size_t>(channels.size(), 3); ++c) // the fourth is opacity
        mask |= channels[c] != 0;
    return mask;
}

void writePng(const std::filesystem::path& file, const cv::Mat& image) {
    std::vector<uchar> bytes;
    cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 3});
    writeFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

} // namespace core
