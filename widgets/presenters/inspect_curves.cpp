// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect_curves.h"

#include <cmath>

#include "widgets/presenters/inspect_columns.h"

namespace widgets {

InspectCurves inspectCurves(const FitOutcome& outcome) {
    InspectCurves curves;
    for (std::size_t column = 0; column < outcome.methods.size(); ++column) {
        const MethodOutcome& method = outcome.methods[column];
        if (method.isFixed)
            continue;
        Curve error{QString::fromStdString(method.method), columnColour(outcome, column), false, false, {}};
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
