// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QTimer>
#include <QUndoStack>

#include "core/annotation/annotation_set.h"
#include "core/annotation/edit.h"
#include "core/io/store/annotation_store.h"
#include "widgets/document/edit_target.h"

namespace widgets {

/// The annotations of the open sequence, their history and their file. Every edit is in the file before push() returns;
/// the history of an earlier run can be undone and redone as if it had been made now. It knows no view and no model.
class AnnotationDocument : public QObject, private EditTarget {
    Q_OBJECT

public:
    explicit AnnotationDocument(QObject* parent = nullptr);
    ~AnnotationDocument() override;

    /// What a file holds; it may be read on any thread.
    struct Content {
        std::unique_ptr<core::AnnotationStore> store; ///< null: the annotations live in memory only
        core::AnnotationSet set;
        core::AnnotationHistory history;
    };
    /// Opens the file and reads it all. Throws core::Error.
    static Content read(const std::filesystem::path& file, core::StoreAccess access = core::StoreAccess::ReadWrite);

    /// Takes over what was read; the content before is closed.
    void open(Content content);
    void close();
    bool isOpen() const { return m_isOpen; }

    /// All marks and notes, with the preview applied.
    const core::AnnotationSet& annotations() const { return m_set; }
    QUndoStack* undoStack() { return &m_undoStack; }
    const QUndoStack* undoStack() const { return &m_undoStack; }
    const core::AnnotationStore* store() const { return m_store.get(); }

    bool isReadOnly() const { return m_store && m_store->isReadOnly(); }
    /// Name under which marks are made; never empty.
    const std::string& rater() const override { return m_rater; }
    void setRater(const std::string& rater);

    /// Makes an edit: one undo step, in the file at once. Empty edits do nothing; a read-only document refuses and says
    /// so.
    void push(const core::Edit& edit);
    /// Joins an edit to the newest step (a row of nudges); a new step if there is none to join or `joins` is another
    /// one's.
    void amend(const core::Edit& edit, int joins);

    /// Shows an edit of the set as it is shown now without making it (a drag under way); it adds to the preview that is
    /// there. push(), undo and redo end it.
    void preview(const core::Edit& edit);
    void clearPreview();

    /// True while something that was done is not in the file yet, because writing failed; it is tried again.
    bool hasUnsaved() const { return !m_pending.empty(); }
    /// Tries at once; true if everything is in the file now.
    bool saveNow();
    QDateTime lastSaved() const { return m_lastSaved; }
    /// Frame of the newest edit, if there is one.
    std::optional<int> lastEditedFrame() const;

    /// Small settings that are kept with the annotations (order of joints, hidden cameras).
    std::optional<std::string> setting(const std::string& key) const;
    void setSetting(const std::string& key, const std::string& value);

signals:
    /// Everything is to be in the file now: what was typed and not kept yet can still be pushed. Also sent before
    /// aboutToClose().
    void aboutToSave();
    /// The content is about to go.
    void aboutToClose();
    /// Another file, or none: everything is different.
    void opened();
    /// The set changed as this edit says (also by undo, redo and previews).
    void changed(const core::Edit& applied);
    void raterChanged();
    /// Everything done so far is in the file.
    void saved();
    void saveFailed(const QString& message);
    /// An edit was not made, and why.
    void refused(const QString& message);

private:
    enum class Direction { Forward, Back };

    void restoreHistory(const core::AnnotationHistory& history);
    void applyToSet(const core::Edit& edit);
    void perform(const core::Edit& edit, StoreCall call) override;
    void writePending();

    std::unique_ptr<core::AnnotationStore> m_store;
    core::AnnotationSet m_set;
    core::Edit m_preview;
    QUndoStack m_undoStack;
    std::string m_rater = "annotator";
    std::deque<StoreCall> m_pending;
    QTimer m_retry;
    QDateTime m_lastSaved;
    bool m_isOpen = false;
    bool m_restoring = false;
};

} // namespace widgets
