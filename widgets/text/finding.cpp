// SPDX-License-Identifier: MIT
#include "widgets/text/finding.h"

#include <algorithm>
#include <cmath>

#include <QLocale>

#include "widgets/text/advice.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr double kOutlierSeverity = 10;
constexpr double kNoPointSeverity = 100;

constexpr LocalText findingWords{"widgets::Finding"};

void addOutliers(std::vector<Finding>& findings, const core::JointId& joint, const core::JointReconstruction& found,
                 int frame, double badRmsPx) {
    for (const core::ViewReconstruction& view : found.views) {
        if (!view.outlier || !view.errorPx)
            continue;
        findings.push_back({frame, joint, view.camera,
                            findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "click in %1 is %2 px off"))
                                .arg(QString::fromStdString(view.camera), QLocale().toString(*view.errorPx, 'f', 1)),
                            kOutlierSeverity + *view.errorPx / badRmsPx});
    }
}

QString noPointText(const core::CurveGap& gap) {
    return findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "no 3D point: click in %1 is %2"))
        .arg(QString::fromStdString(gap.camera), curveGapText(gap));
}

QString textOf(const core::QualityFinding& found) {
    const double size = std::abs(found.value);
    switch (found.kind) {
    case core::QualityKind::Disagreement:
        if (!found.curveOf.empty())
            return noPointText({found.camera, found.curveOf, size, {}, {}});
        return found.camera.empty() ? findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "no 3D point from its clicks"))
                                    : findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "click in %1 is %2 px off"))
                                          .arg(QString::fromStdString(found.camera), localNumber(size, 1));
    case core::QualityKind::BoneLength:
        return (found.value > 0 ? findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "bone %1 % longer than usual"))
                                : findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "bone %1 % shorter than usual")))
            .arg(localNumber(size, 0));
    case core::QualityKind::JointAngle:
        return findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "bent %1\u00b0 beyond its limit"))
            .arg(localNumber(size, 0));
    case core::QualityKind::FingerOrder:
        return findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "fingers exchanged? %1 mm out of order"))
            .arg(localNumber(size, 1));
    case core::QualityKind::HandMixUp:
        return findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "left and right exchanged?"));
    case core::QualityKind::SharedPixel:
        return findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "on the same pixel as another joint in %1"))
            .arg(QString::fromStdString(found.camera));
    case core::QualityKind::OutsidePicture:
        break;
    }
    return findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "mark is %1 px outside the picture of %2"))
        .arg(localNumber(size, 0), QString::fromStdString(found.camera));
}

/// How bad a doubt is, in units of its limit.
double severityOf(const core::QualityFinding& found, double badRmsPx) {
    const core::QualityOptions limits;
    const double size = std::abs(found.value);
    switch (found.kind) {
    case core::QualityKind::Disagreement:
        return found.camera.empty() || !found.curveOf.empty() ? kNoPointSeverity : kOutlierSeverity + size / badRmsPx;
    case core::QualityKind::BoneLength:
        return size / (100 * limits.boneLengthShare);
    case core::QualityKind::JointAngle:
        return size / limits.angleToleranceDeg;
    case core::QualityKind::FingerOrder:
        return size / limits.knuckleToleranceMm;
    case core::QualityKind::HandMixUp:
        return kOutlierSeverity;
    case core::QualityKind::OutsidePicture:
        return kOutlierSeverity;
    case core::QualityKind::SharedPixel:
        break;
    }
    return 1;
}

} // namespace

Finding findingOf(const core::QualityFinding& found, double badRmsPx) {
    return {found.frame, found.joint, found.camera, textOf(found), severityOf(found, badRmsPx)};
}

std::vector<Finding> findingsOf(const std::map<core::JointId, core::JointReconstruction>& joints, int frame,
                                double badRmsPx) {
    std::vector<Finding> findings;
    for (const auto& [joint, found] : joints) {
        addOutliers(findings, joint, found, frame, badRmsPx);
        if (!found.hasPoint()) {
            if (!found.gaps.empty())
                findings.push_back(
                    {frame, joint, found.gaps.front().camera, noPointText(found.gaps.front()), kNoPointSeverity});
            else if (found.manualViews >= 2)
                findings.push_back({frame,
                                    joint,
                                    {},
                                    findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "no 3D point: %1"))
                                        .arg(failureInWords(found.result.failure)),
                                    kNoPointSeverity});
            continue;
        }
        const double rms = found.result.point->rmsPx;
        if (rms > badRmsPx)
            findings.push_back({frame,
                                joint,
                                {},
                                findingWords(QT_TRANSLATE_NOOP("widgets::Finding", "error of %1 px"))
                                    .arg(QLocale().toString(rms, 'f', 1)),
                                rms / badRmsPx});
    }
    std::stable_sort(findings.begin(), findings.end(),
                     [](const auto& a, const auto& b) { return a.severity > b.severity; });
    return findings;
}

} // namespace widgets
