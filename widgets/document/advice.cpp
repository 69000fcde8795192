// SPDX-License-Identifier: MIT
#include "widgets/document/advice.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "widgets/document/edit_text.h"

namespace widgets {

namespace {

QString text(const char* source, int count = -1) {
    return QCoreApplication::translate("widgets::Advice", source, nullptr, count);
}

QString number(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

} // namespace

/// Core's phrases, for the translators' files.
[[maybe_unused]] constexpr const char* kReasons[] = {
    QT_TRANSLATE_NOOP("widgets::Advice", "fewer than two views"),
    QT_TRANSLATE_NOOP("widgets::Advice", "a click lies where the lens model cannot be inverted"),
    QT_TRANSLATE_NOOP("widgets::Advice", "rays are nearly parallel"),
    QT_TRANSLATE_NOOP("widgets::Advice", "the rays meet behind a camera"),
    QT_TRANSLATE_NOOP("widgets::Advice", "views disagree"),
};

QString reasonText(const std::string& reason) {
    return text(reason.c_str());
}

QString summaryText(const core::JointId& joint, const core::JointReconstruction& found) {
    QStringList parts{jointText(joint), text(QT_TRANSLATE_N_NOOP("widgets::Advice", "%n view(s)"), found.manualViews)};
    if (found.hasPoint()) {
        parts << text(QT_TRANSLATE_NOOP("widgets::Advice", "%1 px")).arg(number(found.result.point->rmsPx, 2))
              << text(QT_TRANSLATE_NOOP("widgets::Advice", "%1 mm")).arg(number(core::sigmaMm(found.result.point->covariance), 2));
    }
    return parts.join(QStringLiteral("  \u00b7  "));
}

QString adviceText(const core::JointId& joint, const core::JointReconstruction& found, int cameras) {
    const QString name = QString::fromStdString(joint.joint);
    const QString next = found.nextViews.empty() ? QString() : QString::fromStdString(found.nextViews.front().camera);
    if (joint.joint.empty())
        return text(QT_TRANSLATE_NOOP("widgets::Advice", "Choose a joint on the left."));
    if (cameras < 2)
        return text(QT_TRANSLATE_NOOP("widgets::Advice", "A joint needs at least two cameras."));
    if (found.manualViews == 0)
        return text(QT_TRANSLATE_NOOP("widgets::Advice", "Click %1 in any view.")).arg(name);
    if (!found.suspect.empty())
        return text(QT_TRANSLATE_NOOP("widgets::Advice", "The click in %1 disagrees with the others: check it."))
            .arg(QString::fromStdString(found.suspect));
    if (!found.hasPoint() && found.manualViews >= 2)
        return text(QT_TRANSLATE_NOOP("widgets::Advice", "No 3D point: %1.")).arg(reasonText(found.result.reason));
    if (!found.hasPoint())
        return next.isEmpty() ? text(QT_TRANSLATE_NOOP("widgets::Advice", "Click %1 in a second view.")).arg(name)
                              : text(QT_TRANSLATE_NOOP("widgets::Advice", "Click %1 in a second view, best in %2.")).arg(name, next);
    if (found.status == core::JointStatus::Done)
        return text(QT_TRANSLATE_NOOP("widgets::Advice", "Done in every view: go on with the next joint."));
    if (next.isEmpty())
        return text(QT_TRANSLATE_NOOP("widgets::Advice", "Accept the remaining views with Space, or mark them as not placeable."));
    return text(QT_TRANSLATE_NOOP("widgets::Advice", "Click in %1 next (\u2192 %2 mm), or accept with Space."))
        .arg(next, number(found.nextViews.front().predictedSigmaMm, 2));
}

std::string advisedCamera(const core::JointReconstruction& found) {
    const bool isStuck = !found.suspect.empty() || (!found.hasPoint() && found.manualViews >= 2);
    const bool asks = found.manualViews > 0 && !isStuck && found.status != core::JointStatus::Done;
    return asks && !found.nextViews.empty() ? found.nextViews.front().camera : std::string();
}

} // namespace widgets
