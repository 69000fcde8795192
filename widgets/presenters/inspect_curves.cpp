// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect_curves.h"

#include <cmath>

#include "widgets/views/joint_colours.h"

namespace widgets {

InspectCurves inspectCurves(const FitOutcome& outcome) {
    InspectCurves curves;
    for (const MethodOutcome& method : outcome.methods) {
        Curve error{QString::fromStdString(method.method), methodColour(method.method), false, false, {}};
        Curve cost = error;
        if (!std::isnan(outcome.initialErrorMm))
            error.points.emplace_back(0, outcome.initialErrorMm);
        for (std::size_t i = 0; i < method.iterationErrorMm.size(); ++i) {
            if (!std::isnan(method.iterationErrorMm[i]))
                error.points.emplace_back(double(i + 1), method.iterationErrorMm[i]);
            cost.points.emplace_back(double(i), method.result.history[i].costMm2);
        }
        if (!error.points.empty())
            curves.errors.push_back(std::move(error));
        curves.costs.push_back(std::move(cost));
    }
    return curves;
}

} // namespace widgets
