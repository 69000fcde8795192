// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include <QImage>
#include <QString>

#include "core/fitting/match_rule.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/views/camera/mesh_layer.h"
#include "widgets/views/camera/view_mark.h"

namespace widgets {

/// What can be drawn of an inspected method over a camera's picture.
enum class InspectLayer {
    Contour,    ///< the observed silhouette's outline as the method saw it, orientation as a hue
    Rim,        ///< rim points of the posed hands with their normals
    Matches,    ///< p -> q by residual; refused ones dashed
    Difference, ///< silhouettes: missed and extra pixels
    Field,      ///< what a rim point of one direction would cost, pixel by pixel
    Error,      ///< the mesh by its vertices' distance to the recorded pose
    Uncertainty ///< 95 % regions of the result's joints, as the fit judged them
};
inline constexpr std::array kInspectLayers{InspectLayer::Contour,    InspectLayer::Rim,   InspectLayer::Matches,
                                           InspectLayer::Difference, InspectLayer::Field, InspectLayer::Error,
                                           InspectLayer::Uncertainty};

/// "contour", "rim", ...: as scripts and settings call it.
QString inspectLayerId(InspectLayer layer);
std::optional<InspectLayer> inspectLayerOf(const QString& id);

/// The largest residual (px), field value (px) and vertex error (mm) of the colour scales.
inline constexpr double kResidualScalePx = 20;
inline constexpr double kFieldScalePx = 60;
inline constexpr double kErrorScaleMm = 10;
/// From 0 (good) to 1 (the scale's end or beyond): dark blue to yellow.
QColor scaleColour(double share);

/// One method's matches in one camera; null without a trace or an outline there.
struct ShownMatches {
    const core::CameraTarget* target = nullptr;
    const std::vector<core::MatchRecord>* matches = nullptr;
};
/// At the pose after `iteration` steps (0 is the start): what the next step was solved from and, at the end, what it
/// would be.
ShownMatches shownMatches(const MethodOutcome& method, int camera, int iteration);

/// Everything that lies over one view.
struct InspectOverlay {
    OverlayShapes shapes;
    QImage field; ///< difference or field, the image's size or a fraction of it; null for none
    double iou = std::numeric_limits<double>::quiet_NaN(); ///< of the silhouettes, where their difference is shown
};
/// `posed` is the method's mesh at that iteration, `fieldAngleRad` the direction of the field's rim point. Slow with
/// Difference or Field: not for the window's thread.
InspectOverlay inspectOverlay(const MethodOutcome& method, const core::Camera& camera, int cameraIndex, int iteration,
                              const std::set<InspectLayer>& shown, const MeshLayer& posed, double fieldAngleRad);

/// The mesh with the colours of its vertices' distance to `truth`'s; unchanged where the surfaces do not correspond.
MeshLayer colouredByError(MeshLayer posed, const MeshLayer& truth);

/// The direction of the rim point nearest to a pixel, rad; empty without rim points.
std::optional<float> rimAngleAt(const ShownMatches& shown, QPointF px);

} // namespace widgets
