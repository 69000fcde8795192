// SPDX-License-Identifier: MIT
#include "widgets/presenters/tracker_column.h"

#include <limits>

#include "core/benchmark/joint_errors.h"
#include "widgets/jobs/hand_model_fit.h"
#include "widgets/text/local_text.h"

namespace widgets {

MethodOutcome trackerColumn(const core::Dataset& dataset, const FitOutcome& outcome,
                            const core::ExternalEstimates& estimates, const std::string& columnId) {
    constexpr LocalText text{"widgets::TrackerColumn"};
    MethodOutcome column;
    column.method = columnId;
    column.isFixed = true;
    column.errorMm = std::numeric_limits<double>::quiet_NaN();
    const auto found = estimates.joints.find({outcome.sequence, outcome.request.start, outcome.request.test});
    if (found == estimates.joints.end()) {
        column.failure =
            text(QT_TRANSLATE_NOOP("widgets::TrackerColumn", "%1 has no estimate of frame %2 from frame %3"))
                .arg(QString::fromStdString(estimates.name))
                .arg(outcome.request.test)
                .arg(outcome.request.start);
        return column;
    }
    core::JointPoints points;
    for (const auto& [joint, positionMm] : found->second)
        points[joint].pointInWorld = positionMm;
    if (auto fit = fitModelToPoints(dataset, outcome.request.test, points))
        column.result.poses = std::move(fit->poses);
    column.errorMm = core::jointErrors(core::jointNames(dataset.hands), found->second, outcome.reference).meanMm;
    return column;
}

} // namespace widgets
