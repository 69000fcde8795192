// SPDX-License-Identifier: MIT
#include "tests/support/camera_ring.h"

#include <cmath>
#include <string>

namespace test {

std::vector<core::Camera> cameraRing(int count, bool withLens) {
    std::vector<core::Camera> cameras;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * i / count;
        const Eigen::Vector3d centre(900 * std::cos(angle), i % 2 ? 350 : -250, 900 * std::sin(angle));
        const Eigen::Vector3d z = -centre.normalized();
        const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitY()).normalized();
        core::Camera camera;
        camera.name = "cam" + std::to_string(i);
        camera.size = {1080, 1920};
        camera.intrinsics << 1800 + 7 * i, 0, 541.3, 0, 1803 + 7 * i, 955.8, 0, 0, 1;
        if (withLens)
            camera.distortion = {-0.12, 0.05, 0.001, -0.0008, 0.0};
        camera.cameraFromWorld.rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
        camera.cameraFromWorld.translation = -(camera.cameraFromWorld.rotation * centre);
        cameras.push_back(camera);
    }
    return cameras;
}

} // namespace test
