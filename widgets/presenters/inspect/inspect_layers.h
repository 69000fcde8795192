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
#include "core/io/dataset/dataset.h"
#include "widgets/jobs/fit_runner.h"
#include "widgets/presenters/inspect/match_look.h"
#include "widgets/views/camera/mesh_layer.h"
#include "widgets/views/camera/view_mark.h"

namespace widgets {

/// What can be drawn of an inspected method over a camera's picture.
enum class InspectLayer {
    Contour,    ///< the observed silhouette's outline as the method saw it, orientation as a hue
    Rim,        ///< rim points of the posed hands with their normals
    Matches,    ///< p -> q by residual or finger; refused ones dashed, a look per reason
    Difference, ///< silhouettes: missed and extra pixels, without what the fit left out
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

/// One colour per direction; opposite directions have opposite hues.
QColor directionColour(double angleRad);

/// One method's matches in one camera; null without a trace or an outline there.
struct ShownMatches {
    const core::CameraTarget* target = nullptr;
    const std::vector<core::MatchRecord>* matches = nullptr;
    const std::vector<core::ConvexRegion>* leftOut = nullptr; ///< of the picture: forearms that take no part
};
/// At the pose after `iteration` steps (0 is the start): what the next step was solved from and, at the end, what it
/// would be.
ShownMatches shownMatches(const MethodOutcome& method, int camera, int iteration);

/// What is drawn, and how.
struct OverlayChoice {
    std::set<InspectLayer> shown;
    double fieldAngleRad = 0; ///< direction of the field's rim point
    MatchChoice matches = MatchChoice::ByDistance;
    bool isShown(InspectLayer layer) const { return shown.count(layer) > 0; }
    bool operator==(const OverlayChoice&) const = default;
};

/// Everything that lies over one view.
struct InspectOverlay {
    OverlayShapes shapes;
    QImage field; ///< difference or field, the image's size or a fraction of it; null for none
    double iou = std::numeric_limits<double>::quiet_NaN(); ///< of the silhouettes, where their difference is shown
    bool isWithoutForearm = false;                         ///< there is one in the difference, which does not count
    std::set<core::MatchVerdict> refusals;                 ///< reasons among the matches that are drawn
};
/// `posed` is the method's mesh at that iteration. Slow with Difference or Field: not for the window's thread.
InspectOverlay inspectOverlay(const MethodOutcome& method, const core::Dataset& dataset, int camera, int iteration,
                              const OverlayChoice& choice, const MeshLayer& posed);

/// The mesh with the colours of its vertices' distance to `truth`'s; unchanged where the surfaces do not correspond.
MeshLayer colouredByError(MeshLayer posed, const MeshLayer& truth);

/// The rim point nearest to a pixel; null without rim points.
const core::MatchRecord* nearestRimPoint(const ShownMatches& shown, QPointF px);

} // namespace widgets
