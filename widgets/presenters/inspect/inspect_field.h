// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QImage>

#include "core/fitting/match_rule.h"
#include "core/geometry/camera.h"
#include "widgets/views/camera/view_mark.h"

namespace widgets {

/// Between the places that arrows of a field begin at, pixels.
inline constexpr int kFieldArrowStepPx = 48;

/// The colours of costs: `colour` of 0 to 1 for 0 to `mostPx` and beyond.
struct FieldScale {
    double mostPx = 0;
    QColor (*colour)(double share) = nullptr;
};

struct FieldOverlay {
    QImage picture; ///< a quarter of the image's size
    OverlayShapes arrows;
};

/// What a rim point of that direction would cost at every pixel, as a picture that is clear where the method would
/// refuse it, and arrows from a grid of pixels to the contour points that it would be matched to, where these are near
/// enough for the scale of colours. Each arrow ends in a dot.
FieldOverlay fieldOverlay(const core::CameraTarget& target, const core::MatchRule& rule, const core::Camera& camera,
                          double angleRad, const FieldScale& scale);

} // namespace widgets
