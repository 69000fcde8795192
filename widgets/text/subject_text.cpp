// SPDX-License-Identifier: MIT
#include "widgets/text/subject_text.h"

#include <algorithm>

#include <QStringList>

#include "core/rig/rig_findings.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText subjectText{"widgets::SubjectText"};

QString unitText(const core::MeasuredSubject& measured) {
    const QString unit = QLocale().toString(measured.unitMm, 'g', 4);
    return (measured.isUnitKnown
                ? subjectText(QT_TRANSLATE_NOOP("widgets::SubjectText",
                                                "The calibration is not in mm: its unit is %1 mm. The cameras of the "
                                                "new dataset are in mm."))
                : subjectText(QT_TRANSLATE_NOOP("widgets::SubjectText",
                                                "The calibration is not in mm: its unit is %1 mm if this hand is as "
                                                "large as the model, so that scale says nothing. The cameras of the "
                                                "new dataset are in mm.")))
        .arg(unit);
}

QString framesText(const core::MeasuredSubject& measured) {
    const auto used = static_cast<int>(measured.frames.size());
    return used < measured.annotatedFrames
               ? subjectText(
                     QT_TRANSLATE_NOOP("widgets::SubjectText", "%1 of %2 annotated frames were used, evenly drawn."))
                     .arg(QLocale().toString(used), QLocale().toString(measured.annotatedFrames))
               : subjectText(QT_TRANSLATE_N_NOOP("widgets::SubjectText", "%n annotated frame(s) were used."), used);
}

QString outlinesText(const core::SubjectResult& result) {
    if (result.girthKept)
        return subjectText(
            QT_TRANSLATE_NOOP("widgets::SubjectText", "Fewer than 3 frames: only the scale is measured."));
    return result.outlineFrames > 0
               ? subjectText(QT_TRANSLATE_N_NOOP("widgets::SubjectText", "Outlines of %n frame(s) fit to %1 mm."),
                             result.outlineFrames)
                     .arg(localNumber(result.outlineSigmaMm, 2))
               : subjectText(QT_TRANSLATE_NOOP("widgets::SubjectText",
                                               "No masks of frames in which all hands are annotated: the girth stays "
                                               "the model's."));
}

QString handText(core::Side side, const core::SubjectHand& hand) {
    return (side == core::Side::Left
                ? subjectText(
                      QT_TRANSLATE_NOOP("widgets::SubjectText",
                                        "Left hand: scale %1 \u00b1 %2, girth %3 \u00b1 %4 mm; joints fit to %5 mm."))
                : subjectText(
                      QT_TRANSLATE_NOOP("widgets::SubjectText",
                                        "Right hand: scale %1 \u00b1 %2, girth %3 \u00b1 %4 mm; joints fit to %5 mm.")))
        .arg(localNumber(hand.scale.value, 4), localNumber(hand.scale.sigma, 4),
             (hand.girthMm.value > 0 ? QStringLiteral("+") : QString()) + localNumber(hand.girthMm.value, 2),
             localNumber(hand.girthMm.sigma, 2), localNumber(hand.jointRmsMm, 2));
}

} // namespace

QString subjectSourceText(const std::string& sequence, int annotatedFrames, bool hasMasks) {
    const QString frames =
        subjectText(QT_TRANSLATE_N_NOOP("widgets::SubjectText", "%n annotated frame(s)"), annotatedFrames);
    const QString masks = hasMasks ? subjectText(QT_TRANSLATE_NOOP("widgets::SubjectText", "masks"))
                                   : subjectText(QT_TRANSLATE_NOOP("widgets::SubjectText", "no masks"));
    return QStringLiteral("%1: %2, %3").arg(QString::fromStdString(sequence), frames, masks);
}

QString subjectResultText(const core::MeasuredSubject& measured) {
    QStringList lines;
    if (measured.unitMm != 1)
        lines << unitText(measured);
    const std::vector<core::RigFinding> faults = core::findRigFaults(measured.rigHealth);
    if (std::any_of(faults.begin(), faults.end(),
                    [](const auto& fault) { return fault.kind != core::RigFindingKind::CameraUnknown; }))
        lines << subjectText(QT_TRANSLATE_NOOP("widgets::SubjectText",
                                               "The calibration does not fit the clicks everywhere (Quality, Cameras): "
                                               "measure again after it is refined."));
    lines << framesText(measured) + QLatin1Char(' ') + outlinesText(measured.result);
    if (measured.result.lengthsKept && !measured.result.girthKept)
        lines << subjectText(
            QT_TRANSLATE_NOOP("widgets::SubjectText", "Fewer than 5 frames: bones keep the model's proportions."));
    for (std::size_t h = 0; h < measured.result.hands.size(); ++h)
        lines << handText(measured.dataset.hands[h].side, measured.result.hands[h]);
    return lines.join(QLatin1Char('\n'));
}

} // namespace widgets
