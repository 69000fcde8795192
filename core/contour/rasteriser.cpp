// SPDX-License-Identifier: MIT
#include "core/contour/rasteriser.h"

#include <limits>

#include "core/contour/triangle_scan.h"

namespace core {

namespace {

struct ProjectedVertex {
    Eigen::Vector2d px;
    double depthMm; ///< not positive: behind the camera
    FixedPoint fixed;
};

std::vector<ProjectedVertex> projectVertices(const Camera& camera, const std::vector<Eigen::Vector3d>& points) {
    // Far outside the image nothing can be drawn, and the exact edge functions must not overflow.
    constexpr double kFarPx = 1 << 18;
    std::vector<ProjectedVertex> projected(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto px = project(camera, points[i]);
        if (!px || !(px->cwiseAbs().maxCoeff() < kFarPx)) {
            projected[i].depthMm = -1;
            continue;
        }
        const double depth = camera.cameraFromWorld.rotation.row(2).dot(points[i]) +
                             camera.cameraFromWorld.translation.z();
        projected[i] = {*px, depth, toFixed(*px)};
    }
    return projected;
}

/// Calls draw(global triangle index, its three vertices) for every triangle in front of the camera.
template <typename Draw>
void forEachTriangle(const Camera& camera, const std::vector<PosedSurface>& surfaces, Draw&& draw) {
    int offset = 0;
    for (const PosedSurface& surface : surfaces) {
        const std::vector<ProjectedVertex> vertices = projectVertices(camera, *surface.verticesInWorld);
        for (const auto& [a, b, c] : *surface.triangles) {
            if (vertices[a].depthMm > 0 && vertices[b].depthMm > 0 && vertices[c].depthMm > 0) {
                draw(offset, vertices[a], vertices[b], vertices[c]);
            }
            ++offset;
        }
    }
}

/// 1/z is linear in the image: value + byX * x + byY * y.
struct InverseDepth {
    double value, byX, byY;
};

InverseDepth inverseDepth(const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c) {
    const Eigen::Vector2d ab = b.px - a.px, ac = c.px - a.px;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    const double ia = 1 / a.depthMm, ib = 1 / b.depthMm - ia, ic = 1 / c.depthMm - ia;
    if (std::abs(area) < 1e-9) {
        return {ia, 0, 0};
    }
    const double byX = (ib * ac.y() - ic * ab.y()) / area;
    const double byY = (ic * ab.x() - ib * ac.x()) / area;
    return {ia - byX * a.px.x() - byY * a.px.y(), byX, byY};
}

} // namespace

DepthImage renderDepth(const Camera& camera, const std::vector<PosedSurface>& surfaces) {
    const cv::Size size(camera.size.width, camera.size.height);
    DepthImage image{cv::Mat(size, CV_32F, cv::Scalar(std::numeric_limits<float>::infinity())),
                     cv::Mat(size, CV_32S, cv::Scalar(-1))};
    forEachTriangle(camera, surfaces,
                    [&](int index, const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c) {
                        const InverseDepth plane = inverseDepth(a, b, c);
                        scanTriangle(a.fixed, b.fixed, c.fixed, camera.size, [&](int x, int y) {
                            const auto depth = static_cast<float>(1 / (plane.value + plane.byX * x + plane.byY * y));
                            float& stored = image.depthMm.ptr<float>(y)[x];
                            if (depth < stored) {
                                stored = depth;
                                image.triangle.ptr<int>(y)[x] = index;
                            }
                        });
                    });
    return image;
}

cv::Mat renderMask(const Camera& camera, const std::vector<PosedSurface>& surfaces) {
    cv::Mat mask(camera.size.height, camera.size.width, CV_8U, cv::Scalar(0));
    forEachTriangle(camera, surfaces,
                    [&](int, const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c) {
                        scanTriangle(a.fixed, b.fixed, c.fixed, camera.size,
                                     [&](int x, int y) { mask.ptr<unsigned char>(y)[x] = 255; });
                    });
    return mask;
}

cv::Mat renderHandsMask(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses) {
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        vertices.push_back(posedVertices(hands[h], poses[h]));
    }
    std::vector<PosedSurface> surfaces;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        surfaces.push_back({&vertices[h], &hands[h].mesh.triangles});
    }
    return renderMask(camera, surfaces);
}

} // namespace core
