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

/// Where the phases of a method's schedule begin: what moved, and on which level of the mesh. None for a fixed pose,
/// and for a method with one phase only the beginning of that.
std::vector<PlotMark> phaseMarks(const MethodOutcome& method);

} // namespace widgets
