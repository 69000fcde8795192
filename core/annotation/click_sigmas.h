// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/geometry/triangulation.h"

namespace core {

/// How far the clicks of one rater scatter, per axis, px.
struct RaterSigma {
    double clickPx = 1;                    ///< over all cameras
    std::vector<double> clickPxByCamera{}; ///< parallel to the cameras; where a camera has few clicks near `clickPx`
    int clicks = 0;                        ///< that it was estimated from
    int wrongClicks = 0;                   ///< beyond 5 sigma: they took no part
    bool isAssumed = true;                 ///< too few clicks to know: 1 px stands
    bool operator==(const RaterSigma&) const = default;
};

/// What the clicks of a dataset are worth: the scatter of every rater's hand in every camera, and how far each camera's
/// calibration is off (estimateClickSigmas in core/rig). A click is off by both: its variance is the sum of their
/// squares.
struct ClickSigmas {
    std::map<std::string, RaterSigma> raters;
    /// Per camera: rms over its clicks, per axis, of the shift that its wrong calibration makes, px. Empty while that
    /// is not known.
    std::vector<double> systematicPx{};

    /// Of that rater; assumed for a rater who is not there.
    const RaterSigma& of(const std::string& rater) const;
    /// The options with the sigmas of that rater's clicks; unchanged but for isSigmaAssumed if they are not known.
    TriangulationOptions optionsFor(const std::string& rater, TriangulationOptions options = {}) const;
    bool operator==(const ClickSigmas&) const = default;
};

/// True if a triangulation would hardly notice: the same raters are known, and no sigma differs by more than 2 %.
bool areAlike(const ClickSigmas& a, const ClickSigmas& b);

} // namespace core
