// SPDX-License-Identifier: MIT
#include "core/contour/rasteriser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "core/contour/triangle_scan.h"

namespace core {

namespace {

struct ProjectedVertex {
    Eigen::Vector2d px;
    double inverseDepth; ///< 1/mm; not positive: behind the camera
    FixedPoint fixed;
};

/// Surfaces as one camera sees them.
class ProjectedSurfaces {
public:
    ProjectedSurfaces(const Camera& camera, const std::vector<PosedSurface>& surfaces)
        : m_surfaces(surfaces) {
        for (const PosedSurface& surface : surfaces)
            m_vertices.push_back(projected(camera, *surface.verticesInWorld));
    }

    /// Calls draw(global triangle index, its three vertices) for every triangle in front of the camera.
    template <typename Draw>
    void forEachTriangle(Draw&& draw) const {
        int offset = 0;
        for (std::size_t s = 0; s < m_surfaces.size(); ++s) {
            const std::vector<ProjectedVertex>& vertices = m_vertices[s];
            for (const auto& [a, b, c] : *m_surfaces[s].triangles) {
                if (vertices[a].inverseDepth > 0 && vertices[b].inverseDepth > 0 && vertices[c].inverseDepth > 0)
                    draw(offset, vertices[a], vertices[b], vertices[c]);
                ++offset;
            }
        }
    }

    /// The smallest part of the image in which something may be drawn.
    cv::Rect bounds(const ImageSize& size) const {
        Eigen::AlignedBox2d box;
        for (const std::vector<ProjectedVertex>& vertices : m_vertices) {
            for (const ProjectedVertex& v : vertices)
                if (v.inverseDepth > 0)
                    box.extend(v.px);
        }
        if (box.isEmpty())
            return {};
        const cv::Point topLeft(static_cast<int>(std::floor(box.min().x())),
                                static_cast<int>(std::floor(box.min().y())));
        const cv::Point bottomRight(static_cast<int>(std::ceil(box.max().x())),
                                    static_cast<int>(std::ceil(box.max().y())));
        return cv::Rect(topLeft, bottomRight + cv::Point(1, 1)) & cv::Rect(0, 0, size.width, size.height);
    }

private:
    static std::vector<ProjectedVertex> projected(const Camera& camera, const std::vector<Eigen::Vector3d>& points) {
        // Far outside the image nothing can be drawn, and the exact edge functions must not overflow.
        constexpr double kFarPx = 1 << 17;
        std::vector<ProjectedVertex> result(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto px = project(camera, points[i]);
            if (!px || !(px->cwiseAbs().maxCoeff() < kFarPx)) {
                result[i].inverseDepth = -1;
                continue;
            }
            const double depth =
                camera.cameraFromWorld.rotation.row(2).dot(points[i]) + camera.cameraFromWorld.translation.z();
            result[i] = {*px, 1 / depth, toFixed(*px)};
        }
        return result;
    }

    const std::vector<PosedSurface>& m_surfaces;
    std::vector<std::vector<ProjectedVertex>> m_vertices;
};

/// 1/z is linear in the image: value + byX * x + byY * y. A pixel's centre may fall into a sliver by the rounding of
/// its corners alone: its depth is kept within theirs.
struct InverseDepth {
    double value, byX, byY;
    double low, high;

    double at(int x, int y) const { return std::clamp(value + byX * x + byY * y, low, high); }
};

InverseDepth inverseDepth(const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c) {
    const Eigen::Vector2d ab = b.px - a.px, ac = c.px - a.px;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    const double ia = a.inverseDepth, ib = b.inverseDepth - ia, ic = c.inverseDepth - ia;
    const double low = ia + std::min({0.0, ib, ic}), high = ia + std::max({0.0, ib, ic});
    if (std::abs(area) < 1e-9)
        return {ia, 0, 0, low, high};
    const double byX = (ib * ac.y() - ic * ab.y()) / area;
    const double byY = (ic * ab.x() - ib * ac.x()) / area;
    return {ia - byX * a.px.x() - byY * a.px.y(), byX, byY, low, high};
}

/// Draws the part of the image that `window` covers.
DepthImage drawDepth(const ProjectedSurfaces& surfaces, const ImageSize& size, const cv::Rect& window) {
    DepthImage image{cv::Mat(window.size(), CV_32F), cv::Mat(window.size(), CV_32S)};
    if (window.empty())
        return image;
    std::fill_n(image.depthMm.ptr<float>(), image.depthMm.total(), std::numeric_limits<float>::infinity());
    std::fill_n(image.triangle.ptr<int>(), image.triangle.total(), -1);
    surfaces.forEachTriangle(
        [&](int index, const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c) {
            std::optional<InverseDepth> plane; // most triangles of a small picture cover no pixel's centre
            scanTriangle(a.fixed, b.fixed, c.fixed, size, [&](int x, int y) {
                if (!plane)
                    plane = inverseDepth(a, b, c);
                const auto depth = static_cast<float>(1 / plane->at(x, y));
                float& stored = image.depthMm.ptr<float>(y - window.y)[x - window.x];
                if (depth < stored) {
                    stored = depth;
                    image.triangle.ptr<int>(y - window.y)[x - window.x] = index;
                }
            });
        });
    return image;
}

} // namespace

DepthImage renderDepth(const Camera& camera, const std::vector<PosedSurface>& surfaces) {
    return drawDepth(ProjectedSurfaces(camera, surfaces), camera.size, {0, 0, camera.size.width, camera.size.height});
}

DepthWindow renderDepthWindow(const Camera& camera, const std::vector<PosedSurface>& surfaces) {
    const ProjectedSurfaces projected(camera, surfaces);
    const cv::Rect window = projected.bounds(camera.size);
    return {window, drawDepth(projected, camera.size, window)};
}

cv::Mat renderMask(const Camera& camera, const std::vector<PosedSurface>& surfaces) {
    cv::Mat mask(camera.size.height, camera.size.width, CV_8U, cv::Scalar(0));
    ProjectedSurfaces(camera, surfaces)
        .forEachTriangle([&](int, const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c) {
            scanTriangle(a.fixed, b.fixed, c.fixed, camera.size,
                         [&](int x, int y) { mask.ptr<unsigned char>(y)[x] = 255; });
        });
    return mask;
}

cv::Mat renderHandsMask(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses) {
    std::vector<std::vector<Eigen::Vector3d>> vertices;
    for (std::size_t h = 0; h < hands.size(); ++h)
        vertices.push_back(posedVertices(hands[h], poses[h]));
    std::vector<PosedSurface> surfaces;
    for (std::size_t h = 0; h < hands.size(); ++h)
        surfaces.push_back({&vertices[h], &hands[h].mesh.triangles});
    return renderMask(camera, surfaces);
}

} // namespace core
