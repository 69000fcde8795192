// SPDX-License-Identifier: MIT
#include "widgets/document/quality_finding.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>

#include "widgets/document/advice.h"

namespace widgets {

namespace {

QString text(const char* source) {
    return QCoreApplication::translate("widgets::QualityFinding", source);
}

void addOutliers(std::vector<QualityFinding>& findings, const core::JointId& joint, const core::JointReconstruction& found, int frame,
                 double badRmsPx) {
    for (const core::ViewReconstruction& view : found.views) {
        if (!view.outlier || !view.errorPx)
            continue;
        findings.push_back({frame, joint, view.camera,
                            text(QT_TRANSLATE_NOOP("widgets::QualityFinding", "%1 disagrees with the other views by %2 px"))
                                .arg(QString::fromStdString(view.camera), QLocale().toString(*view.errorPx, 'f', 1)),
                            10 + *view.errorPx / badRmsPx});
    }
}

} // namespace

std::vector<QualityFinding> findingsOf(const Reconstructions& reconstructions, int frame, double badRmsPx) {
    std::vector<QualityFinding> findings;
    for (const auto& [joint, found] : reconstructions.joints()) {
        addOutliers(findings, joint, found, frame, badRmsPx);
        if (!found.hasPoint()) {
            if (found.manualViews >= 2)
                findings.push_back({frame, joint, {},
                                    text(QT_TRANSLATE_NOOP("widgets::QualityFinding", "no 3D point: %1")).arg(reasonText(found.result.reason)),
                                    100});
            continue;
        }
        const double rms = found.result.point->rmsPx;
        if (rms > badRmsPx)
            findings.push_back({frame, joint, {},
                                text(QT_TRANSLATE_NOOP("widgets::QualityFinding", "error of %1 px")).arg(QLocale().toString(rms, 'f', 1)),
                                rms / badRmsPx});
    }
    std::stable_sort(findings.begin(), findings.end(), [](const auto& a, const auto& b) { return a.severity > b.severity; });
    return findings;
}

} // namespace widgets
