// SPDX-License-Identifier: MIT
#include "tests/support/shapes/ball.h"

namespace test {

Ball makeBall(const Eigen::Vector3d& centre, double radius, int rings, int sectors) {
    Ball ball;
    for (int i = 0; i <= rings; ++i) {
        for (int j = 0; j < sectors; ++j) {
            const double polar = M_PI * i / rings, azimuth = 2 * M_PI * j / sectors;
            const Eigen::Vector3d n(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                    std::sin(polar) * std::sin(azimuth));
            ball.normals.push_back(n);
            ball.vertices.push_back(centre + radius * n);
        }
    }
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < sectors; ++j) {
            const int a = i * sectors + j, b = i * sectors + (j + 1) % sectors;
            ball.triangles.push_back({a, b, b + sectors});
            ball.triangles.push_back({a, b + sectors, a + sectors});
        }
    }
    return ball;
}

} // namespace test
