// SPDX-License-Identifier: MIT
#include "widgets/presenters/tracker_column.h"

#include <algorithm>
#include <limits>

#include "core/benchmark/joint_errors.h"
#include "widgets/jobs/hand_model_fit.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

/// Whether a hand that the estimate has joints of has no pose, or no hand has one.
bool lacksPose(const core::Dataset& dataset, const core::JointPoints& points, const core::HandPoses& poses) {
    const auto isPosed = [&](std::size_t hand) { return hand < poses.size() && poses[hand].size() > 0; };
    bool anyPosed = false, anyLost = false;
    for (std::size_t hand = 0; hand < dataset.hands.size(); ++hand) {
        const bool isNamed = std::any_of(points.begin(), points.end(), [&](const auto& point) {
            return point.first.hand == dataset.hands[hand].side;
        });
        anyPosed = anyPosed || isPosed(hand);
        anyLost = anyLost || (isNamed && !isPosed(hand));
    }
    return anyLost || !anyPosed;
}

} // namespace

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
    if (lacksPose(dataset, points, column.result.poses))
        column.note =
            text(QT_TRANSLATE_NOOP(
                     "widgets::TrackerColumn",
                     "%1 has fewer than three joints of a hand, or they lie on a line: that hand cannot be drawn."))
                .arg(QString::fromStdString(estimates.name));
    column.errorMm = core::jointErrors(core::jointNames(dataset.hands), found->second, outcome.reference).meanMm;
    return column;
}

} // namespace widgets
