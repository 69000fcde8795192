// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/annotation/annotation_set.h"
#include "core/geometry/camera.h"
#include "core/geometry/triangulation.h"

namespace core {

/// How far clicks scatter, estimated from how badly they agree.
struct ClickNoise {
    double sigmaPx = 0;                            ///< standard deviation per axis, all cameras together
    std::map<std::string, double> sigmaPxByCamera; ///< cameras with enough clicks only
    int clicks = 0;                                ///< inlying clicks of joints with three or more of them
    double degreesOfFreedom = 0;                   ///< 2 * clicks - 3 * joints
    int outliers = 0;                              ///< clicks left out
};

/// Estimates the scatter of one rater's clicks from the residuals of all joints that three or more views agree on:
/// sigma^2 = sum r^2 / (2 clicks - 3 joints); per camera each residual is weighed by its leverage, tr(I - J C J^T /
/// sigma^2). The outlier gate follows the estimate (from `startSigmaPx` down) until it stays. Empty with fewer than
/// `leastJoints` such joints.
std::optional<ClickNoise> estimateClickNoise(const AnnotationSet& set, const std::vector<Camera>& cameras,
                                             const std::string& rater, const TriangulationOptions& options = {},
                                             double startSigmaPx = 8, int leastJoints = 5);

} // namespace core
