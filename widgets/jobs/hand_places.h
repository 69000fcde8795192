// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QRectF>

#include "core/annotation/annotation_set.h"
#include "core/geometry/camera.h"
#include "core/hand/hand_model.h"
#include "core/io/dataset/dataset.h"

namespace widgets {

/// Where one hand is, as far as something tells.
struct HandPlace {
    core::Side side = core::Side::Left;
    std::vector<Eigen::Vector3d> pointsInWorld; ///< some or all of its joints, mm; never empty
    bool startsAtRoot = false;                  ///< the first point is where the arm begins
};

/// The hands in these poses; a hand without a pose is left out.
std::vector<HandPlace> handsInPose(const std::vector<core::HandModel>& hands, const core::HandPoses& poses);
/// The hands by the marks of all raters: their 3D joints in `frame` or, for a hand without, in the nearest frame that
/// has some.
std::vector<HandPlace> handsOfMarks(const core::AnnotationSet& set, const std::vector<core::Camera>& cameras,
                                    int frame);

/// The part of the image that the hands fill, with some room around them, px; empty if no hand is seen.
std::optional<QRectF> handsInView(const core::Camera& camera, const std::vector<HandPlace>& hands);
/// The part of the image that the marks of all raters in this view fill, with room around them: in `frame` or the
/// nearest frame with some.
std::optional<QRectF> marksInView(const core::Camera& camera, const core::AnnotationSet& set, int frame);

/// Per camera where the silhouettes of a frame lie, px; null where there are none. Throws Error if a mask file cannot
/// be read.
std::vector<QRectF> handsOfMasks(const core::Dataset& dataset, const core::Sequence& sequence, int frame);

/// `box` clipped to the image; empty if they do not meet.
std::optional<QRectF> withinImage(const core::Camera& camera, const QRectF& box);

} // namespace widgets
