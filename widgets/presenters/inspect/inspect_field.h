// SPDX-License-Identifier: MIT
#pragma once

#include "core/fitting/match_rule.h"
#include "core/geometry/camera.h"
#include "widgets/presenters/inspect/inspect_layers.h"

namespace widgets {

/// Between the places that arrows of a field begin at, pixels.
inline constexpr int kFieldArrowStepPx = 48;

/// What a rim point of that direction would cost at every pixel, as a picture that is clear where the method would
/// refuse it, and arrows from a grid of pixels to the contour points that it would be matched to, where these are near
/// enough for the scale of colours. Each arrow ends in a dot.
void addField(const core::CameraTarget& target, const core::MatchRule& rule, const core::Camera& camera,
              double angleRad, InspectOverlay& overlay);

} // namespace widgets
