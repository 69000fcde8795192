// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect_curves.h"

#include <algorithm>
#include <cmath>

#include "widgets/presenters/inspect_columns.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText curveWords{"widgets::InspectCurves"};

PlotMark markOf(const core::FitIteration& step, double x) {
    if (step.rigidOnly)
        return {x, curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "rigid")),
                curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "Hands move as a whole, their fingers do not"))};
    switch (step.level) {
    case 0:
        return {x, curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "coarse mesh")),
                curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "All joints move, by a coarse mesh"))};
    case 1:
        return {x, curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "medium mesh")),
                curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "All joints move, by a finer mesh"))};
    default:
        return {x, curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "full mesh")),
                curveWords(QT_TRANSLATE_NOOP("widgets::InspectCurves", "All joints move, by the whole mesh"))};
    }
}

} // namespace

std::vector<PlotMark> phaseMarks(const MethodOutcome& method) {
    std::vector<PlotMark> marks;
    const auto& history = method.result.history;
    for (std::size_t i = 0; i < history.size(); ++i)
        if (i == 0 || history[i].rigidOnly != history[i - 1].rigidOnly || history[i].level != history[i - 1].level)
            marks.push_back(markOf(history[i], double(i)));
    return marks;
}

InspectCurves inspectCurves(const FitOutcome& outcome) {
    InspectCurves curves;
    std::size_t last = 0;
    for (const MethodOutcome& method : outcome.methods)
        last = std::max(last, method.result.history.size());
    for (std::size_t column = 0; column < outcome.methods.size(); ++column) {
        const MethodOutcome& method = outcome.methods[column];
        if (method.isFixed) { // the same at every iteration: a line to compare with
            const QString name = columnTitle(columnOf(method.method));
            if (method.errorMm > 0 && last > 0)
                curves.errors.push_back({name,
                                         columnColour(outcome, column),
                                         true,
                                         false,
                                         {{0, method.errorMm}, {static_cast<double>(last), method.errorMm}}});
            continue;
        }
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
