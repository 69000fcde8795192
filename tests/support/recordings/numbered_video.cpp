// SPDX-License-Identifier: MIT
#include "tests/support/recordings/numbered_video.h"

namespace test {

cv::Mat numberedPicture(int number, cv::Size size) {
    cv::Mat image(size, CV_8UC3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            image.at<cv::Vec3b>(y, x) =
                cv::Vec3b(static_cast<uchar>(3 * x + 2 * number), static_cast<uchar>(2 * y + 5 * number), 90);
        }
    }
    const int w = size.width / 5, h = size.height / 3;
    for (int bit = 0; bit < 10; ++bit) {
        image(cv::Rect(bit % 5 * w, bit / 5 * h, w, h))
            .setTo(number >> bit & 1 ? cv::Scalar::all(255) : cv::Scalar::all(0));
    }
    return image;
}

int numberInPicture(const cv::Mat& image) {
    const int w = image.cols / 5, h = image.rows / 3;
    int number = 0;
    for (int bit = 0; bit < 10; ++bit) {
        number |= (cv::mean(image(cv::Rect(bit % 5 * w + w / 4, bit / 5 * h + h / 4, w / 2, h / 2)))[1] > 127 ? 1 : 0)
                  << bit;
    }
    return number;
}

bool hasFfmpeg() {
    return std::system("command -v ffmpeg >/dev/null 2>&1") == 0;
}

bool encodeNumbered(const std::filesystem::path& file, const std::string& options, const std::vector<int>& numbers,
                    int rate) {
    const std::string command = "ffmpeg -hide_banner -loglevel quiet -y -f rawvideo -pixel_format bgr24 -video_size " +
                                std::to_string(kNumberedWidth) + "x" + std::to_string(kNumberedHeight) +
                                " -framerate " + std::to_string(rate) + " -i - " + options + " \"" + file.string() +
                                "\" 2>/dev/null";
    std::FILE* pipe = ::popen(command.c_str(), "w");
    if (pipe == nullptr)
        return false;
    for (const int number : numbers) {
        const cv::Mat image = numberedPicture(number);
        std::fwrite(image.data, 1, image.total() * image.elemSize(), pipe);
    }
    return ::pclose(pipe) == 0;
}

std::vector<int> countTo(int count) {
    std::vector<int> numbers;
    for (int i = 0; i < count; ++i)
        numbers.push_back(i);
    return numbers;
}

} // namespace test
