// SPDX-License-Identifier: MIT
#include "widgets/text/edit_text.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <QCoreApplication>

namespace widgets {

namespace {

QString text(const char* source, int count = -1) {
    return QCoreApplication::translate("widgets::EditText", source, nullptr, count);
}

QString singleMarkText(const core::MarkChange& change) {
    const QString joint = jointText(change.key.joint);
    const QString camera = QString::fromStdString(change.key.camera);
    if (!change.after)
        return text(QT_TRANSLATE_NOOP("widgets::EditText", "delete %1 in %2")).arg(joint, camera);
    if (change.after->state == core::MarkState::Unplaceable)
        return text(QT_TRANSLATE_NOOP("widgets::EditText", "mark %1 as not placeable in %2")).arg(joint, camera);
    if (!change.before)
        return (change.after->placement == core::Placement::Proposed
                    ? text(QT_TRANSLATE_NOOP("widgets::EditText", "propose %1 in %2"))
                : change.after->placement == core::Placement::Auto
                    ? text(QT_TRANSLATE_NOOP("widgets::EditText", "accept %1 in %2"))
                    : text(QT_TRANSLATE_NOOP("widgets::EditText", "place %1 in %2")))
            .arg(joint, camera);
    if (change.before->px != change.after->px)
        return text(QT_TRANSLATE_NOOP("widgets::EditText", "move %1 in %2")).arg(joint, camera);
    return (change.after->state == core::MarkState::Occluded
                ? text(QT_TRANSLATE_NOOP("widgets::EditText", "mark %1 as occluded in %2"))
                : text(QT_TRANSLATE_NOOP("widgets::EditText", "mark %1 as visible in %2")))
        .arg(joint, camera);
}

/// First words of the labels of edits over many marks, and how they are said.
struct ManyMarks {
    std::string_view beginning;
    const char* source;
};
constexpr std::array kManyMarks = {
    ManyMarks{"accept", QT_TRANSLATE_N_NOOP("widgets::EditText", "accept %n mark(s)")},
    ManyMarks{"copy", QT_TRANSLATE_N_NOOP("widgets::EditText", "copy a pose (%n mark(s))")},
    ManyMarks{"interpolate", QT_TRANSLATE_N_NOOP("widgets::EditText", "interpolate (%n mark(s))")},
    ManyMarks{"swap", QT_TRANSLATE_N_NOOP("widgets::EditText", "swap left and right (%n mark(s))")},
    ManyMarks{"delete", QT_TRANSLATE_N_NOOP("widgets::EditText", "delete %n mark(s)")},
    ManyMarks{"import", QT_TRANSLATE_N_NOOP("widgets::EditText", "import %n mark(s)")},
    ManyMarks{"propose", QT_TRANSLATE_N_NOOP("widgets::EditText", "propose %n mark(s)")},
};

} // namespace

QString sideText(core::Side side) {
    return side == core::Side::Left ? text(QT_TRANSLATE_NOOP("widgets::EditText", "left"))
                                    : text(QT_TRANSLATE_NOOP("widgets::EditText", "right"));
}

QString shortJointText(const core::JointId& joint) {
    return (joint.hand == core::Side::Left ? text(QT_TRANSLATE_NOOP("widgets::EditText", "L %1"))
                                           : text(QT_TRANSLATE_NOOP("widgets::EditText", "R %1")))
        .arg(QString::fromStdString(joint.joint));
}

QString jointText(const core::JointId& joint) {
    return QStringLiteral("%1 %2").arg(sideText(joint.hand), QString::fromStdString(joint.joint));
}

QString editText(const core::Edit& edit) {
    if (edit.marks.size() == 1 && edit.notes.empty())
        return singleMarkText(edit.marks.front());
    if (edit.marks.empty() && edit.notes.size() == 1)
        return text(QT_TRANSLATE_NOOP("widgets::EditText", "note on frame %1")).arg(edit.notes.front().frame);
    const int count = static_cast<int>(edit.marks.size());
    const auto known = std::find_if(kManyMarks.begin(), kManyMarks.end(),
                                    [&](const ManyMarks& kind) { return edit.label.starts_with(kind.beginning); });
    if (known != kManyMarks.end())
        return text(known->source, count);
    return text(QT_TRANSLATE_N_NOOP("widgets::EditText", "change %n mark(s)"), count);
}

} // namespace widgets
