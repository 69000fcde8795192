// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "tests/support/shapes/ball.h"
#include "widgets/views/camera/mesh_layer.h"

namespace test {

inline widgets::ViewSurfacePtr ballSurface(const Eigen::Vector3d& centre, double radiusMm, int rings = 32) {
    const Ball ball = makeBall(centre, radiusMm, rings, 2 * rings);
    auto surface = std::make_shared<widgets::ViewSurface>();
    surface->verticesInWorld = ball.vertices;
    surface->normalsInWorld = ball.normals;
    surface->triangles = ball.triangles;
    return surface;
}

/// One ball of 100 mm around the origin, which a cameraRing looks at.
inline widgets::MeshLayer ballLayer(const QColor& colour) {
    widgets::MeshLayer layer;
    layer.name = QStringLiteral("ball");
    layer.surfaces = {ballSurface({0, 0, 0}, 100)};
    layer.colour = colour;
    return layer;
}

} // namespace test
