// SPDX-License-Identifier: MIT
#include "widgets/views/camera/mesh_layer.h"

#include <QPainter>

#include "core/contour/shaded_image.h"

namespace widgets {

namespace {

/// The overlay's pixels are those that Qt calls premultiplied ARGB, on a little-endian machine.
QImage imageOf(const cv::Mat& overlay) {
    return QImage(overlay.data, overlay.cols, overlay.rows, static_cast<int>(overlay.step),
                  QImage::Format_ARGB32_Premultiplied)
        .copy();
}

QImage drawLayer(const core::Camera& crop, const MeshLayer& layer) {
    std::vector<core::ShadedSurface> surfaces;
    const Eigen::Vector3f colour(static_cast<float>(layer.colour.redF()), static_cast<float>(layer.colour.greenF()),
                                 static_cast<float>(layer.colour.blueF()));
    for (const ViewSurfacePtr& s : layer.surfaces)
        surfaces.push_back({{&s->verticesInWorld, &s->triangles},
                            &s->normalsInWorld,
                            colour,
                            s->coloursRgb.empty() ? nullptr : &s->coloursRgb});
    core::OverlayOptions options;
    options.style = layer.style == MeshStyle::Wireframe ? core::OverlayStyle::Wireframe : core::OverlayStyle::Shaded;
    options.opacity = static_cast<float>(layer.opacity);
    options.silhouetteEdge = layer.silhouetteEdge;
    return imageOf(core::renderOverlay(crop, surfaces, options));
}

} // namespace

ViewSurfacePtr makeViewSurface(const core::HandModel& hand, const core::Pose& pose) {
    auto surface = std::make_shared<ViewSurface>();
    surface->side = hand.side;
    surface->verticesInWorld = core::posedVertices(hand, pose);
    surface->normalsInWorld = core::vertexNormals(surface->verticesInWorld, hand.mesh.triangles);
    surface->triangles = hand.mesh.triangles;
    return surface;
}

MeshPicture drawMeshLayers(const core::Camera& camera, const std::vector<MeshLayer>& layers, QPointF topLeftPx,
                           QSize size, double scale) {
    const core::Camera crop =
        core::cropped(camera, {topLeftPx.x(), topLeftPx.y()}, {size.width(), size.height()}, scale);
    MeshPicture result{{}, topLeftPx, scale};
    for (const MeshLayer& layer : layers) {
        if (layer.style == MeshStyle::Off || layer.surfaces.empty() || size.isEmpty())
            continue;
        const QImage picture = drawLayer(crop, layer);
        if (result.picture.isNull())
            result.picture = picture;
        else
            QPainter(&result.picture).drawImage(0, 0, picture);
    }
    return result;
}

} // namespace widgets
