// SPDX-License-Identifier: MIT
#include "widgets/document/annotation_document.h"

#include <algorithm>
#include <utility>

#include <QElapsedTimer>

#include "core/error.h"
#include "widgets/document/edit_command.h"
#include "widgets/text/error_text.h"
#include "widgets/text/store_text.h"

namespace widgets {

namespace {
constexpr int kRetryMs = 3000;
constexpr int kHistorySteps = 5000; ///< of an earlier run that can still be undone
constexpr std::size_t kSliceMarks = 250;
constexpr int kSlicesMs = 12; ///< of one turn of the event loop
} // namespace

AnnotationDocument::AnnotationDocument(QObject* parent)
    : QObject(parent) {
    m_writer.setMaxThreadCount(1);
    m_nextSlice.setSingleShot(true);
    m_nextSlice.setInterval(0);
    connect(&m_nextSlice, &QTimer::timeout, this, &AnnotationDocument::applySlices);
    m_retry.setInterval(kRetryMs);
    connect(&m_retry, &QTimer::timeout, this, &AnnotationDocument::writePending);
}

AnnotationDocument::~AnnotationDocument() {
    blockSignals(true); // its receivers are being destroyed, too
    settle();
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
    finishSlices();
    settle();
    m_pending.clear();
    m_retry.stop();
    m_preview = {};
    m_settings.clear();
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

void AnnotationDocument::push(core::Edit edit) {
    amend(std::move(edit), -1);
}

core::Edit AnnotationDocument::rebased(core::Edit edit) {
    if (!m_slices)
        return edit;
    if (edit.marks.size() > kMostAtOnce)
        finishSlices();
    else if (const core::Edit first = m_slices->ahead(edit); !first.empty())
        applyToSet(first);
    for (core::MarkChange& change : edit.marks)
        change.before = core::markAt(m_set, change.key);
    std::erase_if(edit.marks, [](const core::MarkChange& change) { return change.before == change.after; });
    for (core::NoteChange& change : edit.notes)
        change.before = core::noteAt(m_set, change.frame);
    std::erase_if(edit.notes, [](const core::NoteChange& change) { return change.before == change.after; });
    return edit;
}

void AnnotationDocument::amend(core::Edit edit, int joins) {
    clearPreview();
    if (m_isOpen && !isReadOnly())
        edit = rebased(std::move(edit));
    if (edit.empty() || !m_isOpen)
        return;
    if (isReadOnly()) {
        emit refused(tr("Nothing was changed: the annotations are open for reading only (%1).")
                         .arg(readOnlyInWords(m_store->readOnlyReason())));
        return;
    }
    const QUndoCommand* newest = m_undoStack.index() > 0 ? m_undoStack.command(m_undoStack.index() - 1) : nullptr;
    const bool joining = joins >= 0 && newest && newest->id() == joins && !m_undoStack.canRedo();
    m_undoStack.push(new EditCommand(*this, std::move(edit), joins, joining));
}

void AnnotationDocument::preview(core::Edit edit) {
    if (isReadOnly())
        return;
    edit = rebased(std::move(edit));
    if (edit.empty())
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

void AnnotationDocument::perform(const std::shared_ptr<const core::Edit>& edit, EditDirection direction,
                                 StoreCall call) {
    if (m_restoring)
        return;
    clearPreview();
    const bool isLarge = edit->marks.size() > kMostAtOnce;
    if (m_slices && (isLarge || direction == EditDirection::Back))
        finishSlices();
    if (m_store) {
        m_pending.push_back({std::move(call), isLarge});
        writePending();
    }
    if (isLarge) {
        m_slices.emplace(edit, direction);
        m_nextSlice.start();
        emit busyChanged();
    } else {
        applyToSet(direction == EditDirection::Forth ? *edit : core::inverse(*edit));
    }
}

void AnnotationDocument::applySlices() {
    QElapsedTimer clock;
    clock.start();
    while (m_slices && !m_slices->isAtEnd() && !clock.hasExpired(kSlicesMs)) {
        const core::Edit slice = m_slices->next(kSliceMarks);
        if (!slice.empty())
            applyToSet(slice);
    }
    if (m_slices && !m_slices->isAtEnd()) {
        m_nextSlice.start();
        emit busyProgressed();
    } else if (m_slices) {
        m_slices.reset();
        emit busyChanged();
    }
}

void AnnotationDocument::finishSlices() {
    while (m_slices)
        applySlices();
    m_nextSlice.stop();
}

double AnnotationDocument::busyShare() const {
    const double shown = m_slices ? m_slices->share() : 1;
    return m_writing ? std::min(shown, m_outcome->written.load()) : shown;
}

void AnnotationDocument::writePending() {
    if (m_pending.empty() || !m_store || m_writing)
        return;
    try {
        while (!m_pending.empty()) {
            if (m_pending.front().isLarge) {
                writeLarge();
                return;
            }
            m_pending.front().call(*m_store);
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

/// Starts the first pending call on its thread. The document outlives it: settle() waits.
void AnnotationDocument::writeLarge() {
    m_retry.stop();
    m_writing = true;
    m_outcome = std::make_shared<Outcome>();
    m_writer.start([this, store = m_store.get(), call = m_pending.front().call, outcome = m_outcome] {
        store->setWriteProgress([this, outcome](double share) {
            outcome->written = share;
            QMetaObject::invokeMethod(this, &AnnotationDocument::busyProgressed, Qt::QueuedConnection);
        });
        try {
            call(*store);
        } catch (...) {
            outcome->problem = std::current_exception();
        }
        store->setWriteProgress({});
        QMetaObject::invokeMethod(
            this,
            [this, outcome] {
                if (outcome == m_outcome)
                    endLarge();
            },
            Qt::QueuedConnection);
    });
    emit busyChanged();
}

void AnnotationDocument::endLarge() {
    const std::shared_ptr<Outcome> outcome = std::exchange(m_outcome, nullptr);
    m_writing = false;
    try {
        if (outcome->problem)
            std::rethrow_exception(outcome->problem);
        m_pending.pop_front();
    } catch (const core::Error& error) {
        m_retry.start();
        emit saveFailed(errorInWords(error));
        emit busyChanged();
        return;
    }
    if (m_pending.empty()) {
        m_retry.stop();
        m_lastSaved = QDateTime::currentDateTimeUtc();
        emit saved();
    } else {
        writePending();
    }
    emit busyChanged();
}

/// Waits until all that is pending is in the file, or cannot be written.
void AnnotationDocument::settle() {
    while (!m_pending.empty()) {
        const std::size_t before = m_pending.size();
        writePending();
        if (m_writing) {
            m_writer.waitForDone();
            endLarge();
        }
        if (m_pending.size() >= before)
            return;
    }
}

bool AnnotationDocument::saveNow() {
    emit aboutToSave();
    settle();
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
    if (const auto known = m_settings.find(key); known != m_settings.end())
        return known->second;
    if (!m_store)
        return std::nullopt;
    m_writer.waitForDone(); // seldom needed: settings are asked for when a sequence is opened
    const auto value = m_store->setting(key);
    if (value)
        m_settings[key] = *value;
    return value;
}

void AnnotationDocument::setSetting(const std::string& key, const std::string& value) {
    if (m_store && !m_store->isReadOnly()) {
        m_settings[key] = value;
        m_pending.push_back({[key, value](core::AnnotationStore& store) { store.setSetting(key, value); }, false});
    }
    writePending();
}

} // namespace widgets
