// SPDX-License-Identifier: MIT
#include "widgets/text/review_text.h"

#include <cmath>

#include "widgets/text/edit_text.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText reviewText{"widgets::ReviewText"};

bool isLeft(const core::ProposedFrame& frame) {
    return frame.joint.hand == core::Side::Left;
}

QString unsureText(const core::ProposedFrame& frame) {
    constexpr double kSure = 0.2;
    if (frame.doubt < kSure)
        return isLeft(frame) ? reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "quite sure; left hand first"))
                             : reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "quite sure; right hand first"));
    return isLeft(frame) ? reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "views do not agree on the left hand"))
                         : reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "views do not agree on the right hand"));
}

QString boneText(const core::ProposedFrame& frame) {
    return (frame.value > 0
                ? reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "%1: its bone is %2 % longer than usual"))
                : reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "%1: its bone is %2 % shorter than usual")))
        .arg(shortJointText(frame.joint), localNumber(100 * std::abs(frame.value), 0));
}

} // namespace

QString doubtReasonText(const core::ProposedFrame& frame) {
    const int count = static_cast<int>(frame.value);
    switch (frame.reason) {
    case core::DoubtReason::Unsure:
        return unsureText(frame);
    case core::DoubtReason::HandMissing:
        return isLeft(frame) ? reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "the left hand was not found"))
                             : reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "the right hand was not found"));
    case core::DoubtReason::JointsMissing:
        return isLeft(frame)
                   ? reviewText(QT_TRANSLATE_N_NOOP("widgets::ReviewText", "%n joint(s) of the left hand missing"),
                                count)
                   : reviewText(QT_TRANSLATE_N_NOOP("widgets::ReviewText", "%n joint(s) of the right hand missing"),
                                count);
    case core::DoubtReason::BoneLength:
        return boneText(frame);
    case core::DoubtReason::Jump:
        break;
    }
    return (isLeft(frame) ? reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "the left hand jumps by %1 mm"))
                          : reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "the right hand jumps by %1 mm")))
        .arg(localNumber(frame.value, 0));
}

QString firstPassStageText(core::PassStage stage, int done, int total) {
    const auto counted = [&](const char* source) {
        return reviewText(source).arg(QLocale().toString(done), QLocale().toString(total));
    };
    switch (stage) {
    case core::PassStage::Detecting:
        return counted(QT_TRANSLATE_NOOP("widgets::ReviewText", "First pass, detecting: %1 of %2"));
    case core::PassStage::Measuring:
        return counted(QT_TRANSLATE_NOOP("widgets::ReviewText", "First pass, measuring hands: %1 of %2"));
    case core::PassStage::Fitting:
        return counted(QT_TRANSLATE_NOOP("widgets::ReviewText", "First pass, fitting: %1 of %2"));
    case core::PassStage::Tracking:
        break;
    }
    return counted(QT_TRANSLATE_NOOP("widgets::ReviewText", "First pass, tracking: %1 of %2"));
}

QString reviewProgressText(const core::ReviewProgress& progress, int reviewed) {
    if (progress.left == 0)
        return reviewed == 0
                   ? QString()
                   : reviewText(QT_TRANSLATE_N_NOOP("widgets::ReviewText", "All %n frame(s) are reviewed."), reviewed);
    QString text = reviewText(QT_TRANSLATE_N_NOOP("widgets::ReviewText", "%n frame(s) left, "), progress.left) +
                   reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText", "%1 of them doubtful; %2 reviewed."))
                       .arg(QLocale().toString(progress.doubtful), QLocale().toString(reviewed));
    text += QLatin1Char(' ');
    text += progress.expectedErrorMm
                ? reviewText(QT_TRANSLATE_NOOP(
                                 "widgets::ReviewText",
                                 "Error to be expected of those left: %1 mm a joint, as far as reviewed ones tell."))
                      .arg(localNumber(*progress.expectedErrorMm, 1))
            : reviewed >= 3 && !progress.isCorrected
                ? reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText",
                                               "The error of those left is not known until a joint was corrected."))
                : reviewText(QT_TRANSLATE_NOOP("widgets::ReviewText",
                                               "The error of those left is known once three frames are reviewed."));
    return text;
}

} // namespace widgets
