// SPDX-License-Identifier: MIT
#include "core/io/image_file.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/text_file.h"

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
    if (image.empty()) {
        throw Error(ErrorCode::BadInput, file.string(), "", "is no picture that can be read");
    }
    return image;
}

} // namespace

cv::Mat readImage(const std::filesystem::path& file) { return decode(file, cv::IMREAD_COLOR); }

cv::Mat readMask(const std::filesystem::path& file) { return decode(file, cv::IMREAD_GRAYSCALE) > 0; }

void writePng(const std::filesystem::path& file, const cv::Mat& image) {
    std::vector<uchar> bytes;
    cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 3});
    writeFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

} // namespace core
