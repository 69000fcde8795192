// SPDX-License-Identifier: MIT
#include "core/io/calibration/tzionas_cameras.h"

#include <cmath>

#include "core/error.h"
#include "core/io/calibration/cameras_file.h"
#include "core/io/files/text_file.h"

namespace core {

std::vector<Camera> readTzionasCameras(const std::filesystem::path& file, std::optional<ImageSize> size) {
    LineReader lines(file);
    const int count = lines.nextInteger(1, 1000, "the number of cameras");
    std::vector<Camera> cameras;
    for (int c = 0; c < count; ++c) {
        Camera camera;
        camera.name = "cam" + std::to_string(c);
        for (int i = 0; i < 3; ++i) {
            const std::vector<double> row = lines.nextNumbers(3, "a row of K");
            camera.intrinsics.row(i) << row[0], row[1], row[2];
        }
        for (int i = 0; i < 3; ++i) {
            const std::vector<double> row = lines.nextNumbers(4, "a row of R and t");
            camera.cameraFromWorld.rotation.row(i) << row[0], row[1], row[2];
            camera.cameraFromWorld.translation[i] = row[3];
        }
        camera.cameraFromWorld.rotation =
            nearestRotation(camera.cameraFromWorld.rotation, 1e-2).value_or(camera.cameraFromWorld.rotation);
        const Eigen::Vector2d principal = camera.intrinsics.topRightCorner<2, 1>();
        if (!size && (principal.minCoeff() < 0.5 || principal.maxCoeff() > 50000)) {
            throw Error(ErrorCode::BadInput, file.string(), camera.name + ".K",
                        "the image size does not follow from the principal point; give --size WxH");
        }
        camera.size = size.value_or(ImageSize{static_cast<int>(std::lround(2 * principal.x() + 1)),
                                              static_cast<int>(std::lround(2 * principal.y() + 1))});
        cameras.push_back(camera);
    }
    checkCameras(cameras, file.string());
    return cameras;
}

} // namespace core
