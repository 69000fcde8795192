// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QColor>
#include <QMetaType>
#include <QPointF>
#include <QString>

#include "core/annotation/annotation_set.h"

namespace widgets {

/// How a mark came to be, for drawing.
enum class MarkOrigin {
    Manual,  ///< clicked: a solid ring
    Auto,    ///< an accepted reprojection: a thin ring with a dot at its corner
    Proposed ///< pre-placed, not confirmed yet: dashed and faint
};

/// One joint as a view draws it. Positions in recorded image pixels, centres at integers.
struct ViewMark {
    core::JointId joint;
    QPointF px;
    MarkOrigin origin = MarkOrigin::Manual;
    bool occluded = false;
    bool outlier = false;
    bool selected = false;
    std::optional<QPointF> reprojectionPx; ///< of the 3D joint: the thin line goes there
    std::optional<QPointF>
        curvePx;   ///< the nearest place on the curve that the click contradicts: a red line goes there
    QString label; ///< beside the mark if it is named, or if labels are shown
    bool named = false;
    bool operator==(const ViewMark&) const = default;
};

/// The line on which the selected joint must lie, as another view's click says. Bent by the lens, so a polyline.
struct EpipolarGuide {
    std::vector<QPointF> pointsPx;
    QColor colour; ///< of the view it comes from
};

/// The projected 95 % region of the selected joint.
struct UncertaintyEllipse {
    QPointF centrePx;
    double semiAxisAPx = 0; ///< along angleRad
    double semiAxisBPx = 0;
    double angleRad = 0; ///< from x towards y (down)
    QColor colour;
};

/// How far clicks near a place are off, as an arrow from there, drawn as long as it is said here.
struct ResidualArrow {
    QPointF fromPx;
    QPointF toPx;
    QColor colour;
    bool operator==(const ResidualArrow&) const = default;
};

/// Which hand this is, written beside it.
struct HandLabel {
    core::Side side = core::Side::Left;
    QPointF px;           ///< on the hand, where the arm begins
    QPointF awayScreenPx; ///< from there to the label's middle: away from the fingers
    QString text;         ///< a letter
    bool operator==(const HandLabel&) const = default;
};

/// A bone: a straight line between two joints.
struct SkeletonLine {
    QPointF fromPx;
    QPointF toPx;
    QColor colour;
};

/// What an inspected method did, drawn over the image: thin lines, and dots of one colour.
struct OverlayShapes {
    struct Line {
        QPointF fromPx;
        QPointF toPx;
        QColor colour;
        Qt::PenStyle style = Qt::SolidLine;
    };
    struct Dots {
        std::vector<QPointF> px;
        QColor colour;
    };
    std::vector<Line> lines;
    std::vector<Dots> dots;
};

} // namespace widgets

Q_DECLARE_METATYPE(core::JointId)
