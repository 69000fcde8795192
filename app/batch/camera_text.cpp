// SPDX-License-Identifier: MIT
#include "app/batch/camera_text.h"

#include <cstdio>

#include "core/geometry/camera_target.h"

namespace app {

void printCameras(const std::vector<core::Camera>& cameras) {
    const std::optional<Eigen::Vector3d> target = core::commonTarget(cameras);
    for (const core::Camera& camera : cameras) {
        std::printf("%s: %d x %d, focal length %.1f px", camera.name.c_str(), camera.size.width, camera.size.height,
                    camera.intrinsics(0, 0));
        if (target) {
            const std::optional<Eigen::Vector2d> px = core::project(camera, *target);
            std::printf(", %.0f mm from where the cameras look%s", (camera.centreInWorld() - *target).norm(),
                        px && core::isInside(camera.size, *px) ? "" : " (which it does not see)");
        }
        std::printf("\n");
    }
}

} // namespace app
