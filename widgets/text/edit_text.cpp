// SPDX-License-Identifier: MIT
#include "widgets/text/edit_text.h"

#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText editWords{"widgets::EditText"};

QString stateText(core::MarkState state) {
    switch (state) {
    case core::MarkState::Visible:
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "mark %1 as visible in %2"));
    case core::MarkState::Occluded:
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "mark %1 as occluded in %2"));
    case core::MarkState::Unplaceable:
        break;
    }
    return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "mark %1 as not placeable in %2"));
}

/// For an edit of one mark: %1 is the joint, %2 the camera. Empty for kinds that are always said with a count.
QString oneMarkText(const core::EditDescription& description) {
    switch (description.kind) {
    case core::EditKind::Place:
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "place %1 in %2"));
    case core::EditKind::Move:
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "move %1 in %2"));
    case core::EditKind::SetState:
        return stateText(description.state);
    case core::EditKind::Delete:
    case core::EditKind::DeleteRange:
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "delete %1 in %2"));
    case core::EditKind::AcceptJoint:
    case core::EditKind::AcceptFrame:
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "accept %1 in %2"));
    case core::EditKind::Propose:
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "propose %1 in %2"));
    default:
        return {};
    }
}

QString countedText(core::EditKind kind, int count) {
    switch (kind) {
    case core::EditKind::AcceptJoint:
    case core::EditKind::AcceptFrame:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "accept %n mark(s)"), count);
    case core::EditKind::CopyPose:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "copy a pose (%n mark(s))"), count);
    case core::EditKind::Interpolate:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "interpolate (%n mark(s))"), count);
    case core::EditKind::SwapHands:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "swap left and right (%n mark(s))"), count);
    case core::EditKind::Delete:
    case core::EditKind::DeleteRange:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "delete %n mark(s)"), count);
    case core::EditKind::Import:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "import %n mark(s)"), count);
    case core::EditKind::Propose:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "propose %n mark(s)"), count);
    case core::EditKind::FirstPass:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "first pass (%n proposed mark(s))"), count);
    default:
        return editWords(QT_TRANSLATE_N_NOOP("widgets::EditText", "change %n mark(s)"), count);
    }
}

} // namespace

QString sideText(core::Side side) {
    return side == core::Side::Left ? editWords(QT_TRANSLATE_NOOP("widgets::EditText", "left"))
                                    : editWords(QT_TRANSLATE_NOOP("widgets::EditText", "right"));
}

QString shortJointText(const core::JointId& joint) {
    return (joint.hand == core::Side::Left ? editWords(QT_TRANSLATE_NOOP("widgets::EditText", "L %1"))
                                           : editWords(QT_TRANSLATE_NOOP("widgets::EditText", "R %1")))
        .arg(QString::fromStdString(joint.joint));
}

QString jointText(const core::JointId& joint) {
    return QStringLiteral("%1 %2").arg(sideText(joint.hand), QString::fromStdString(joint.joint));
}

QString editText(const core::Edit& edit) {
    const core::EditDescription& what = edit.description;
    if (what.kind == core::EditKind::Other && !what.text.empty())
        return toQString(what.text);
    if (edit.marks.empty() && edit.notes.size() == 1)
        return editWords(QT_TRANSLATE_NOOP("widgets::EditText", "note on frame %1")).arg(edit.notes.front().frame);
    if (const QString one = oneMarkText(what); edit.marks.size() == 1 && !one.isEmpty()) {
        const core::MarkKey& key = edit.marks.front().key;
        return one.arg(jointText(key.joint), toQString(key.camera));
    }
    return countedText(what.kind, static_cast<int>(edit.marks.size()));
}

} // namespace widgets
