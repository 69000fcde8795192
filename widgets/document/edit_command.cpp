// SPDX-License-Identifier: MIT
#include "widgets/document/edit_command.h"

#include "widgets/document/edit_target.h"
#include "widgets/text/edit_text.h"

namespace widgets {

EditCommand::EditCommand(EditTarget& target, core::Edit edit, int joins, bool amends)
    : QUndoCommand(editText(edit))
    , m_target(target)
    , m_edit(std::make_shared<const core::Edit>(std::move(edit)))
    , m_joins(joins)
    , m_amends(amends) {}

void EditCommand::undo() {
    m_target.perform(
        m_edit, EditDirection::Back, [](core::AnnotationStore& store) { store.undo(); });
}

void EditCommand::redo() {
    if (!m_isFirst) {
        m_target.perform(m_edit, EditDirection::Forth, [](core::AnnotationStore& store) { store.redo(); });
        return;
    }
    m_isFirst = false;
    m_target.perform(m_edit, EditDirection::Forth,
                     [edit = m_edit, rater = m_target.rater(), amends = m_amends](core::AnnotationStore& store) {
                         if (amends)
                             store.amend(*edit, rater);
                         else
                             store.commit(*edit, rater);
                     });
}

bool EditCommand::mergeWith(const QUndoCommand* other) {
    const auto& next = *static_cast<const EditCommand*>(other);
    if (!next.m_amends)
        return false;
    m_edit = std::make_shared<const core::Edit>(core::merged(*m_edit, *next.m_edit));
    setText(editText(*m_edit));
    setObsolete(m_edit->empty());
    return true;
}

} // namespace widgets
