// SPDX-License-Identifier: MIT
#include "widgets/panels/note_edit.h"

#include <QKeyEvent>

#include "core/annotation/edits.h"

namespace widgets {

NoteEdit::NoteEdit(AnnotationDocument& document, const Selection& selection, QWidget* parent)
    : QLineEdit(parent)
    , m_document(document)
    , m_selection(selection) {
    setPlaceholderText(tr("Note on this frame"));
    setFocusPolicy(Qt::ClickFocus);
    setClearButtonEnabled(true);
    setAccessibleName(tr("Note on this frame"));
    connect(&document, &AnnotationDocument::aboutToSave, this, &NoteEdit::keepNote);
    connect(&document, &AnnotationDocument::opened, this, &NoteEdit::showNote);
    connect(&document, &AnnotationDocument::changed, this, [this](const core::Edit& edit) {
        if (!edit.notes.empty())
            showNote();
    });
    connect(&selection, &Selection::frameChanged, this, [this] {
        keepNote();
        showNote();
    });
    connect(this, &QLineEdit::editingFinished, this, &NoteEdit::keepNote);
    connect(this, &QLineEdit::returnPressed, this, &QWidget::clearFocus);
    showNote();
}

QString NoteEdit::noteOf(int frame) const {
    const auto& notes = m_document.annotations().notes;
    const auto at = notes.find(frame);
    return at == notes.end() ? QString() : QString::fromStdString(at->second);
}

void NoteEdit::showNote() {
    m_frame = m_selection.frame();
    setText(noteOf(m_frame));
    setEnabled(m_document.isOpen());
    setReadOnly(m_document.isReadOnly());
}

void NoteEdit::keepNote() {
    const QString note = text().trimmed();
    if (m_document.isOpen() && note != noteOf(m_frame))
        m_document.push(core::noteEdit(m_document.annotations(), m_frame, note.toStdString()));
}

/// Escape is ours while a note is written, not a shortcut's.
bool NoteEdit::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QLineEdit::event(event);
}

void NoteEdit::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        showNote();
        clearFocus();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

} // namespace widgets
