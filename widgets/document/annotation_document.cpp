// SPDX-License-Identifier: MIT
#include "widgets/document/annotation_document.h"

#include <algorithm>

#include "core/error.h"
#include "widgets/document/edit_command.h"
#include "widgets/text/error_text.h"
#include "widgets/text/store_text.h"

namespace widgets {

namespace {
constexpr int kRetryMs = 3000;
constexpr int kHistorySteps = 5000; ///< of an earlier run that can still be undone
} // namespace

AnnotationDocument::AnnotationDocument(QObject* parent)
    : QObject(parent) {
    m_retry.setInterval(kRetryMs);
    connect(&m_retry, &QTimer::timeout, this, &AnnotationDocument::writePending);
}

AnnotationDocument::~AnnotationDocument() {
    blockSignals(true); // its receivers are being destroyed, too
    writePending();
}

AnnotationDocument::Content AnnotationDocument::read(const std::filesystem::path& file, core::StoreAccess access) {
    Content content;
    content.store = std::make_unique<core::AnnotationStore>(core::AnnotationStore::open(file, access));
    content.set = content.store->annotations();
    content.history = content.store->history(kHistorySteps);
    return content;
}

void AnnotationDocument::open(Content content) {
    if (m_isOpen) {
        emit aboutToSave();
        emit aboutToClose();
    }
    writePending();
    m_pending.clear();
    m_retry.stop();
    m_preview = {};
    m_store = std::move(content.store);
    m_set = std::move(content.set);
    m_isOpen = true;
    m_lastSaved = {};
    restoreHistory(content.history);
    emit opened();
}

void AnnotationDocument::close() {
    open({});
    m_isOpen = false;
}

void AnnotationDocument::restoreHistory(const core::AnnotationHistory& history) {
    m_restoring = true;
    m_undoStack.clear();
    for (const core::JournalEntry& entry : history.done)
        m_undoStack.push(new EditCommand(*this, entry.edit));
    for (auto entry = history.undone.rbegin(); entry != history.undone.rend(); ++entry)
        m_undoStack.push(new EditCommand(*this, entry->edit));
    m_undoStack.setIndex(static_cast<int>(history.done.size()));
    m_restoring = false;
}

void AnnotationDocument::setRater(const std::string& rater) {
    if (rater.empty() || rater == m_rater)
        return;
    clearPreview();
    m_rater = rater;
    emit raterChanged();
}

void AnnotationDocument::push(const core::Edit& edit) {
    amend(edit, -1);
}

void AnnotationDocument::amend(const core::Edit& edit, int joins) {
    clearPreview();
    if (edit.empty() || !m_isOpen)
        return;
    if (isReadOnly()) {
        emit refused(tr("Nothing was changed: the annotations are open for reading only (%1).")
                         .arg(readOnlyInWords(m_store->readOnlyReason())));
        return;
    }
    const QUndoCommand* newest = m_undoStack.index() > 0 ? m_undoStack.command(m_undoStack.index() - 1) : nullptr;
    const bool joining = joins >= 0 && newest && newest->id() == joins && !m_undoStack.canRedo();
    m_undoStack.push(new EditCommand(*this, edit, joins, joining));
}

void AnnotationDocument::preview(const core::Edit& edit) {
    if (edit.empty() || isReadOnly())
        return;
    m_preview = m_preview.empty() ? edit : core::merged(m_preview, edit);
    applyToSet(edit);
}

void AnnotationDocument::clearPreview() {
    if (m_preview.empty())
        return;
    const core::Edit back = core::inverse(m_preview);
    m_preview = {};
    applyToSet(back);
}

void AnnotationDocument::applyToSet(const core::Edit& edit) {
    core::apply(m_set, edit);
    emit changed(edit);
}

void AnnotationDocument::perform(const core::Edit& edit, StoreCall call) {
    if (m_restoring)
        return;
    clearPreview();
    if (m_store) {
        m_pending.push_back(std::move(call));
        writePending();
    }
    applyToSet(edit);
}

void AnnotationDocument::writePending() {
    if (m_pending.empty() || !m_store)
        return;
    try {
        while (!m_pending.empty()) {
            m_pending.front()(*m_store);
            m_pending.pop_front();
        }
        m_retry.stop();
        m_lastSaved = QDateTime::currentDateTimeUtc();
        emit saved();
    } catch (const core::Error& error) {
        m_retry.start();
        emit saveFailed(errorInWords(error));
    }
}

bool AnnotationDocument::saveNow() {
    emit aboutToSave();
    writePending();
    return m_pending.empty();
}

std::optional<int> AnnotationDocument::lastEditedFrame() const {
    if (m_undoStack.index() == 0)
        return std::nullopt;
    const auto& edit = static_cast<const EditCommand*>(m_undoStack.command(m_undoStack.index() - 1))->edit();
    if (!edit.marks.empty())
        return edit.marks.front().key.frame;
    return edit.notes.empty() ? std::nullopt : std::optional(edit.notes.front().frame);
}

std::optional<std::string> AnnotationDocument::setting(const std::string& key) const {
    return m_store ? m_store->setting(key) : std::nullopt;
}

void AnnotationDocument::setSetting(const std::string& key, const std::string& value) {
    if (m_store && !m_store->isReadOnly())
        m_pending.push_back([key, value](core::AnnotationStore& store) { store.setSetting(key, value); });
    writePending();
}

} // namespace widgets
