// SPDX-License-Identifier: MIT
#include "core/io/segmentation/room_pictures.h"

#include <algorithm>

#include "core/error.h"
#include "core/io/footage/image_file.h"
#include "core/io/footage/image_orientation.h"
#include "core/segmentation/background_difference.h"

namespace core {

namespace fs = std::filesystem;

std::vector<cv::Mat> readRoomPictures(const fs::path& folder, const std::vector<Camera>& cameras) {
    std::vector<cv::Mat> pictures;
    for (const Camera& camera : cameras) {
        std::error_code ignored;
        fs::path file = folder / (camera.name + ".png");
        if (!fs::exists(file, ignored))
            file.replace_extension(".jpg");
        if (!fs::exists(file, ignored))
            throw Error(ErrorCode::NotFound, (folder / (camera.name + ".png")).string(), "",
                        "no such picture (nor .jpg) of " + camera.name + " without hands");
        pictures.push_back(readImage(file));
        const ImageSize size{pictures.back().cols, pictures.back().rows};
        if (size != camera.size)
            throw Error(ErrorCode::BadInput, file.string(), "size",
                        sizeText(size) + ", but " + camera.name + " is calibrated for " + sizeText(camera.size));
    }
    return pictures;
}

std::vector<cv::Mat> medianRoomPictures(const FrameSource& source, std::size_t cameras, int samples,
                                        const std::stop_token& stop) {
    std::vector<cv::Mat> pictures(cameras);
    const int count = std::min(samples, source.frameCount());
    for (std::size_t camera = 0; camera < cameras; ++camera) {
        std::vector<cv::Mat> some;
        for (int i = 0; i < count && !stop.stop_requested(); ++i) {
            const int frame = static_cast<int>((i + 0.5) * source.frameCount() / count);
            if (source.hasPicture(static_cast<int>(camera), frame))
                some.push_back(source.read(static_cast<int>(camera), frame, stop));
        }
        if (!stop.stop_requested())
            pictures[camera] = medianPicture(some);
    }
    return pictures;
}

} // namespace core
