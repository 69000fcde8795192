// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "widgets/jobs/fit_runner.h"
#include "widgets/views/curve_plot.h"

namespace widgets {

/// How error (mm) and cost (mm^2) fell, a curve per method in its colour; x is the iteration, 0 the start pose.
struct InspectCurves {
    std::vector<Curve> errors; ///< none for methods whose error could not be measured
    std::vector<Curve> costs;
};
InspectCurves inspectCurves(const FitOutcome& outcome);

} // namespace widgets
