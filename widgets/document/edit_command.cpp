// SPDX-License-Identifier: MIT
#include "widgets/document/edit_command.h"

#include "widgets/document/annotation_document.h"
#include "widgets/text/edit_text.h"

namespace widgets {

EditCommand::EditCommand(AnnotationDocument& document, core::Edit edit, int joins, bool amends)
    : QUndoCommand(editText(edit))
    , m_document(document)
    , m_edit(std::move(edit))
    , m_joins(joins)
    , m_amends(amends) {}

void EditCommand::undo() {
    m_document.perform(
        core::inverse(m_edit), [](core::AnnotationStore& store) { store.undo(); });
}

void EditCommand::redo() {
    if (!m_isFirst) {
        m_document.perform(m_edit, [](core::AnnotationStore& store) { store.redo(); });
        return;
    }
    m_isFirst = false;
    m_document.perform(m_edit,
                       [edit = m_edit, rater = m_document.rater(), amends = m_amends](core::AnnotationStore& store) {
                           if (amends)
                               store.amend(edit, rater);
                           else
                               store.commit(edit, rater);
                       });
}

bool EditCommand::mergeWith(const QUndoCommand* other) {
    const auto& next = *static_cast<const EditCommand*>(other);
    if (!next.m_amends)
        return false;
    m_edit = core::merged(m_edit, next.m_edit);
    setText(editText(m_edit));
    setObsolete(m_edit.empty());
    return true;
}

} // namespace widgets
