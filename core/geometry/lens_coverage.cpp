// SPDX-License-Identifier: MIT
#include "core/geometry/lens_coverage.h"

namespace core {

double lensCoverage(const Camera& camera) {
    if (!camera.hasLens())
        return 1;
    constexpr int kGrid = 100;
    int covered = 0;
    for (int row = 0; row < kGrid; ++row) {
        for (int column = 0; column < kGrid; ++column) {
            const Eigen::Vector2d px((column + 0.5) / kGrid * camera.size.width - 0.5,
                                     (row + 0.5) / kGrid * camera.size.height - 0.5);
            covered += undistort(camera, px) ? 1 : 0;
        }
    }
    return static_cast<double>(covered) / (kGrid * kGrid);
}

} // namespace core
