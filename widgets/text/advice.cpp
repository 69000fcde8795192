// SPDX-License-Identifier: MIT
#include "widgets/text/advice.h"

#include <algorithm>

#include <QLocale>
#include <QStringList>

#include "widgets/text/edit_text.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText adviceWords{"widgets::Advice"};

} // namespace

QString failureInWords(core::TriangulationFailure failure) {
    using core::TriangulationFailure;
    switch (failure) {
    case TriangulationFailure::FewerThanTwoViews:
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "fewer than two views"));
    case TriangulationFailure::OutsideLensModel:
        return adviceWords(
            QT_TRANSLATE_NOOP("widgets::Advice", "a click lies where the lens model cannot be inverted"));
    case TriangulationFailure::RaysNearlyParallel:
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "rays are nearly parallel"));
    case TriangulationFailure::BehindCamera:
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "the rays meet behind a camera"));
    case TriangulationFailure::ViewsDisagree:
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "views disagree"));
    case TriangulationFailure::None:
        break;
    }
    return {};
}

namespace {

/// Marks in views with a picture.
struct PlacedCount {
    int clicked = 0, accepted = 0, proposed = 0;
};

PlacedCount countPlaced(const core::JointReconstruction& found) {
    PlacedCount count;
    for (const core::ViewReconstruction& view : found.views) {
        if (!view.hasPicture)
            continue;
        const bool placed = view.mark && view.mark->isPlaced();
        const bool settled = view.mark && view.mark->isSettled();
        count.clicked += placed && view.mark->isEvidence();
        count.accepted += placed && !view.mark->isEvidence();
        count.proposed += !settled && (view.mark || (view.reprojectionPx && view.reprojectionInside));
    }
    return count;
}

bool hasOpenProposal(const core::JointReconstruction& found) {
    return std::any_of(
        found.views.begin(), found.views.end(),
        [](const core::ViewReconstruction& view) { return view.mark && view.mark->isProposal(); });
}

/// Two clicks that give no point: how far they are off each other's curves.
QString disagreementText(const core::JointReconstruction& found) {
    const core::CurveGap& first = found.gaps.front();
    const QString camera = QString::fromStdString(first.camera);
    if (found.gaps.size() < 2)
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "No 3D point: the click in %1 is %2."))
            .arg(camera, curveGapText(first));
    const core::CurveGap& second = found.gaps.back();
    return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "No 3D point: the click in %1 is %2, the one in %3 %4."))
        .arg(camera, curveGapText(first), QString::fromStdString(second.camera), curveGapText(second));
}

} // namespace

QString placedText(const core::JointReconstruction& found) {
    const PlacedCount count = countPlaced(found);
    const QString clicked = QLocale().toString(count.clicked);
    return count.accepted == 0 ? clicked : QStringLiteral("%1+%2").arg(clicked, QLocale().toString(count.accepted));
}

QString placedInWords(const core::JointReconstruction& found) {
    const PlacedCount count = countPlaced(found);
    return adviceWords(QT_TRANSLATE_N_NOOP("widgets::Advice",
                                           "%1 clicked, %2 accepted, %3 proposed; %n view(s) have a picture"),
                       found.countedViews)
        .arg(QLocale().toString(count.clicked), QLocale().toString(count.accepted), QLocale().toString(count.proposed));
}

QString curveGapText(const core::CurveGap& gap) {
    return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "%1 px off %2's curve"))
        .arg(localNumber(gap.px, 1), QString::fromStdString(gap.curveOf));
}

QString summaryText(const core::JointId& joint, const core::JointReconstruction& found) {
    QStringList parts{jointText(joint),
                      adviceWords(QT_TRANSLATE_N_NOOP("widgets::Advice", "%1 of %n view(s)"), found.countedViews)
                          .arg(placedText(found))};
    if (found.isAccepted) {
        parts << adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "as proposed"));
    } else if (found.hasPoint()) {
        parts
            << adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "%1 px")).arg(localNumber(found.result.point->rmsPx, 2))
            << adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "%1 mm"))
                   .arg(localNumber(core::sigmaMm(found.result.point->covariance), 2));
    }
    return parts.join(QStringLiteral("  \u00b7  "));
}

QString adviceText(const core::JointId& joint, const core::JointReconstruction& found) {
    const QString name = QString::fromStdString(joint.joint);
    const QString next = found.nextViews.empty() ? QString() : QString::fromStdString(found.nextViews.front().camera);
    if (joint.joint.empty())
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "Choose a joint on the left."));
    if (found.countedViews < 2)
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "A joint needs at least two cameras with a picture."));
    if (found.isAccepted)
        return adviceWords(
                   QT_TRANSLATE_NOOP("widgets::Advice", "Accepted as proposed; click %1 in two views to correct it."))
            .arg(name);
    if (found.manualViews == 0 && found.proposal && hasOpenProposal(found))
        return adviceWords(
                   QT_TRANSLATE_NOOP("widgets::Advice", "Proposed by a program: click %1 in two views if it is wrong."))
            .arg(name);
    if (found.manualViews == 0)
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "Click %1 in any view.")).arg(name);
    if (!found.suspect.empty())
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "The click in %1 disagrees with the others: check it."))
            .arg(QString::fromStdString(found.suspect));
    if (!found.gaps.empty())
        return disagreementText(found);
    if (!found.hasPoint() && found.manualViews >= 2)
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "No 3D point: %1."))
            .arg(failureInWords(found.result.failure));
    if (!found.hasPoint())
        return next.isEmpty()
                   ? adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "Click %1 in a second view.")).arg(name)
                   : adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "Click %1 in a second view, best in %2."))
                         .arg(name, next);
    if (found.status == core::JointStatus::Done)
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "Done in every view: go on with the next joint."));
    if (next.isEmpty())
        return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice",
                                             "Accept the remaining views with Space, or mark them as not placeable."));
    return adviceWords(QT_TRANSLATE_NOOP("widgets::Advice", "Click in %1 next (\u2192 %2 mm), or accept with Space."))
        .arg(next, localNumber(found.nextViews.front().predictedSigmaMm, 2));
}

std::string advisedCamera(const core::JointReconstruction& found) {
    const bool isStuck = !found.suspect.empty() || (!found.hasPoint() && found.manualViews >= 2);
    const bool asks = found.manualViews > 0 && !isStuck && found.status != core::JointStatus::Done;
    return asks && !found.nextViews.empty() ? found.nextViews.front().camera : std::string();
}

} // namespace widgets
