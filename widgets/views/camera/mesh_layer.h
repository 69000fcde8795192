// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QSize>
#include <QString>

#include <Eigen/Core>

#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"

namespace widgets {

/// A posed surface that views share: built once per pose, then never changed. Everything in the world, mm.
struct ViewSurface {
    core::Side side = core::Side::Left;
    std::vector<Eigen::Vector3d> verticesInWorld;
    std::vector<Eigen::Vector3d> normalsInWorld; ///< unit, one per vertex, outward
    std::vector<std::array<int, 3>> triangles;
    std::vector<Eigen::Vector3f> coloursRgb; ///< one per vertex, 0..1, instead of the layer's; or none
};
using ViewSurfacePtr = std::shared_ptr<const ViewSurface>;

/// Skins one hand and computes its normals.
ViewSurfacePtr makeViewSurface(const core::HandModel& hand, const core::Pose& pose);

enum class MeshStyle { Off, Shaded, Wireframe };

/// Surfaces of one origin (the recorded motion, one method's result), drawn in one colour in every view and in the
/// scene.
struct MeshLayer {
    QString name;                         ///< for people: "start", "dch-thres"
    std::vector<ViewSurfacePtr> surfaces; ///< one per visible hand
    QColor colour = QColor(0x9A, 0xA0, 0xA6);
    MeshStyle style = MeshStyle::Shaded;
    double opacity = 0.35; ///< of the faces; in views the silhouette's edge keeps its full strength
    bool silhouetteEdge = true;
    bool operator==(const MeshLayer&) const = default; ///< the same surfaces, not only equal ones
};

/// Mesh layers drawn for one crop of one camera, ready to be laid over its image.
struct MeshPicture {
    QImage picture;    ///< premultiplied ARGB; null if there is nothing to draw
    QPointF topLeftPx; ///< the image pixel of the picture's top left one, as in core::cropped
    double scale = 1;  ///< picture pixels per image pixel
};

/// Draws layers, the first one at the bottom, for the window of the image that starts at `topLeftPx` and has `scale`
/// picture pixels per image pixel (core::cropped). Thread-safe; uses the calling thread only.
MeshPicture drawMeshLayers(const core::Camera& camera, const std::vector<MeshLayer>& layers, QPointF topLeftPx,
                           QSize size, double scale);

} // namespace widgets
