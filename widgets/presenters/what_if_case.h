// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QLineF>
#include <QString>

#include "core/geometry/camera.h"
#include "widgets/jobs/fit_runner.h"

namespace widgets {

inline constexpr double kMostOutlineNoisePx = 4;
inline constexpr int kMostNoiseDraw = 99;

/// A pair under other circumstances than its own.
struct WhatIfCase {
    std::vector<bool> cameras; ///< which take part; empty: all
    double outlineNoisePx = 0; ///< standard deviation by which outlines move across themselves, 0..kMostOutlineNoisePx
    int draw = 0;              ///< which draw of that noise: its seed is outlineNoiseSeed
    bool operator==(const WhatIfCase&) const = default;
    bool isLeftOut(std::size_t camera) const { return camera < cameras.size() && !cameras[camera]; }
};

/// Of the noise of one camera's outline in one draw; draw 0 is the one of always.
std::uint64_t outlineNoiseSeed(int draw, std::size_t camera, const std::string& sequence);

/// The outlines of every camera's silhouette, in its pixels.
using CameraOutlines = std::vector<std::vector<QLineF>>;

/// What is tried in the places of columns, all of it in one case.
struct ColumnTrial {
    WhatIfCase what;
    std::map<std::string, MethodOutcome> methods;     ///< by column id; columns not here are as they were fitted
    std::set<std::string> stale;                      ///< of them: still of the case or the settings before
    std::shared_ptr<const CameraOutlines> outlinesPx; ///< of the silhouettes that were met; null: those of the pair
    bool isComplete = true;                           ///< false: columns are still being fitted
    /// Whether columns show anything else than what was fitted.
    bool isOn() const { return !methods.empty() || !isComplete || what != WhatIfCase(); }
};

/// "outlines with 2 px of noise (draw 0), without cam3"; empty for the pair as it is.
QString caseText(const WhatIfCase& what, const std::vector<core::Camera>& cameras);
/// The same with the settings that are tried: "outlines with 2 px of noise (draw 0), ch with gate=40"; empty if
/// nothing is tried. Says so while columns are still being fitted.
QString trialText(const ColumnTrial& trial, const std::vector<core::Camera>& cameras);

} // namespace widgets
