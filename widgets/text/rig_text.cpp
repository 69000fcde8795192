// SPDX-License-Identifier: MIT
#include "widgets/text/rig_text.h"

#include <algorithm>
#include <cmath>

#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText rigText{"widgets::RigText"};

/// What a finding's sentence is made with.
struct RigWords {
    const core::RigHealth& health;
    const std::vector<std::string>& sequences;

    QString camera(const core::RigFinding& finding) const {
        return QString::fromStdString(health.cameras[static_cast<std::size_t>(finding.camera)].camera);
    }
    QString sequence(int index) const {
        const auto at = static_cast<std::size_t>(index);
        return at < sequences.size() ? QString::fromStdString(sequences[at]) : QLocale().toString(index);
    }
    QString wholeRig(const core::RigFinding& finding) const {
        return rigText(QT_TRANSLATE_NOOP("widgets::RigText",
                                         "%1 of %2 cameras are %3 to %4 px off in every frame: the calibration as a "
                                         "whole does not fit the clicks."))
            .arg(localNumber(finding.value, 0), QLocale().toString(finding.judged), localNumber(finding.leastPx, 1),
                 localNumber(finding.mostPx, 1));
    }
    QString offInSequences(const core::RigFinding& finding) const {
        QStringList names;
        for (const int index : finding.sequences)
            names << sequence(index);
        return rigText(QT_TRANSLATE_N_NOOP("widgets::RigText",
                                           "%1 is %2 px off in the %n sequence(s) %3 only: it stood otherwise there."),
                       names.size())
            .arg(camera(finding), localNumber(finding.value, 1), names.join(QStringLiteral(", ")));
    }
    QString late(const core::RigFinding& finding) const {
        const bool isBehind = finding.value > 0;
        return (isBehind ? rigText(QT_TRANSLATE_NOOP(
                               "widgets::RigText",
                               "%1 is %2 frames behind the others: its residuals go with the joints' motion."))
                         : rigText(QT_TRANSLATE_NOOP(
                               "widgets::RigText",
                               "%1 is %2 frames ahead of the others: its residuals go with the joints' motion.")))
            .arg(camera(finding), localNumber(std::abs(finding.value), 2));
    }
    QString sentence(const core::RigFinding& finding) const {
        const QString value = localNumber(finding.value, 1);
        switch (finding.kind) {
        case core::RigFindingKind::WholeRigOff:
            return wholeRig(finding);
        case core::RigFindingKind::CameraOff:
            return rigText(
                       QT_TRANSLATE_NOOP("widgets::RigText", "%1 is %2 px off in every frame: its calibration moved."))
                .arg(camera(finding), value);
        case core::RigFindingKind::CameraOffInSequence:
            return offInSequences(finding);
        case core::RigFindingKind::CameraMoved:
            return rigText(QT_TRANSLATE_NOOP("widgets::RigText",
                                             "%1 moved before frame %2 of sequence %3: its picture lies %4 px "
                                             "elsewhere from there on."))
                .arg(camera(finding), QLocale().toString(finding.frame), sequence(finding.sequence), value);
        case core::RigFindingKind::CameraDrifts:
            return rigText(QT_TRANSLATE_NOOP("widgets::RigText", "%1 drifts by %2 px in 100 frames of sequence %3."))
                .arg(camera(finding), value, sequence(finding.sequence));
        case core::RigFindingKind::CameraLate:
            return late(finding);
        case core::RigFindingKind::CameraUnknown:
            break;
        }
        return QStringLiteral("%1 (%2)").arg(camera(finding), localNumber(finding.value, 0));
    }
};

QString sigmaOfRaterText(const std::string& rater, const core::RaterSigma& sigma) {
    const QString name = QString::fromStdString(rater);
    if (sigma.isAssumed)
        return rigText(QT_TRANSLATE_NOOP("widgets::RigText",
                                         "Clicks of %1: too few to know how far they scatter; 1 px is assumed."))
            .arg(name);
    const auto [least, most] = std::minmax_element(sigma.clickPxByCamera.begin(), sigma.clickPxByCamera.end());
    return rigText(
               QT_TRANSLATE_NOOP("widgets::RigText", "Clicks of %1 scatter by %2 px per axis (%3 to %4 by camera)."))
        .arg(name, localNumber(sigma.clickPx, 2), localNumber(*least, 2), localNumber(*most, 2));
}

} // namespace

QStringList rigFindingTexts(const core::RigHealth& health, const std::vector<std::string>& sequences) {
    const RigWords words{health, sequences};
    QStringList texts, unknown;
    const std::vector<core::RigFinding> findings = core::findRigFaults(health);
    const bool isWholeRig = !findings.empty() && findings.front().kind == core::RigFindingKind::WholeRigOff;
    for (const core::RigFinding& finding : findings)
        if (!isWholeRig || finding.kind != core::RigFindingKind::CameraOff)
            (finding.kind == core::RigFindingKind::CameraUnknown ? unknown : texts) << words.sentence(finding);
    if (!unknown.isEmpty() && health.cameras.size() >= 3) // of two, neither can confirm the other
        texts << rigText(QT_TRANSLATE_NOOP("widgets::RigText", "Too few clicks that other cameras confirm: %1."))
                     .arg(unknown.join(QStringLiteral(", ")));
    return texts;
}

QString rigNoticeText(const core::RigHealth& health, const std::vector<std::string>& sequences) {
    const auto findings = core::findRigFaults(health);
    if (findings.empty() || findings.front().kind == core::RigFindingKind::CameraUnknown)
        return {};
    return RigWords{health, sequences}.sentence(findings.front());
}

QString clickSigmaText(const core::ClickSigmas& sigmas) {
    QStringList texts;
    for (const auto& [rater, sigma] : sigmas.raters)
        texts << sigmaOfRaterText(rater, sigma);
    if (!sigmas.systematicPx.empty()) {
        const auto [least, most] = std::minmax_element(sigmas.systematicPx.begin(), sigmas.systematicPx.end());
        texts << rigText(QT_TRANSLATE_NOOP("widgets::RigText", "The calibration's own error adds %1 to %2 px."))
                     .arg(localNumber(*least, 2), localNumber(*most, 2));
    }
    return texts.join(QLatin1Char(' '));
}

QString cameraStateText(const core::CameraHealth& camera) {
    if (!camera.isKnown)
        return rigText(QT_TRANSLATE_NOOP("widgets::RigText", "too few clicks"));
    QStringList states;
    if (camera.isOff)
        states << rigText(QT_TRANSLATE_NOOP("widgets::RigText", "off"));
    const bool isOffSomewhere = std::any_of(camera.sequences.begin(), camera.sequences.end(),
                                            [](const core::SequenceHealth& one) { return one.isOff; });
    if (!camera.isOff && isOffSomewhere)
        states << rigText(QT_TRANSLATE_NOOP("widgets::RigText", "partly off"));
    if (camera.isLate)
        states << (*camera.delayFrames > 0 ? rigText(QT_TRANSLATE_NOOP("widgets::RigText", "late"))
                                           : rigText(QT_TRANSLATE_NOOP("widgets::RigText", "early")));
    if (camera.hasMoved)
        states << rigText(QT_TRANSLATE_NOOP("widgets::RigText", "moved"));
    if (camera.isDrifting)
        states << rigText(QT_TRANSLATE_NOOP("widgets::RigText", "drifts"));
    return states.isEmpty() ? rigText(QT_TRANSLATE_NOOP("widgets::RigText", "fits"))
                            : states.join(QStringLiteral(", "));
}

QString refinementNeedsText(const core::RigHealth& health, const core::RefinementNeeds& needs) {
    if (!health.canTellCameras())
        return rigText(QT_TRANSLATE_NOOP("widgets::RigText",
                                         "Two cameras cannot tell which of them is off: a refinement needs three."));
    switch (needs.advice) {
    case core::RefinementAdvice::NeedsMoreJoints:
        return rigText(QT_TRANSLATE_NOOP("widgets::RigText",
                                         "Cameras can be refined from %1 joints on that three cameras or more have "
                                         "clicked (%2 so far)."))
            .arg(QLocale().toString(needs.leastJoints), QLocale().toString(needs.wellSeenJoints));
    case core::RefinementAdvice::NotNeeded:
        return rigText(QT_TRANSLATE_NOOP("widgets::RigText", "The calibration fits the clicks."));
    case core::RefinementAdvice::NeedsMoreFrames:
        return rigText(QT_TRANSLATE_NOOP("widgets::RigText",
                                         "Refining is worth it from %1 frames and %2 joints on (%3 and %4 so far)."))
            .arg(QLocale().toString(needs.worthwhileFrames), QLocale().toString(needs.worthwhileJoints),
                 QLocale().toString(health.frames), QLocale().toString(needs.wellSeenJoints));
    case core::RefinementAdvice::Worthwhile:
        break;
    }
    return rigText(QT_TRANSLATE_NOOP("widgets::RigText", "There are enough clicks to refine the calibration."));
}

} // namespace widgets
