// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <QUndoStack>

#include "core/annotation/annotation_set.h"
#include "core/annotation/edit.h"
#include "core/io/store/annotation_store.h"
#include "widgets/document/edit_slices.h"
#include "widgets/document/edit_target.h"

namespace widgets {

/// The annotations of the open sequence, their history and their file. Every edit is in the file before push() returns;
/// the history of an earlier run can be undone and redone as if it had been made now. It knows no view and no model.
///
/// An edit of more than kMostAtOnce marks (a first pass, an import, and taking such a step back) holds nothing up: it
/// reaches annotations() slice by slice as the event loop turns, each with its changed(), and the file by one
/// transaction on another thread. Until that is done (hasUnsaved, isBusy) what is pushed is applied at once and gets
/// into the file after it; a process that ends in between leaves the file as it was before. Closing waits for the file.
class AnnotationDocument : public QObject, private EditTarget {
    Q_OBJECT

public:
    static constexpr std::size_t kMostAtOnce = 2000; ///< marks of an edit that is made at once

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

    /// Makes an edit: one undo step, in the file at once (large ones soon). Empty edits do nothing; a read-only
    /// document refuses and says so.
    void push(core::Edit edit);
    /// Joins an edit to the newest step (a row of nudges); a new step if there is none to join or `joins` is another
    /// one's.
    void amend(core::Edit edit, int joins);

    /// Shows an edit of the set as it is shown now without making it (a drag under way); it adds to the preview that is
    /// there. push(), undo and redo end it.
    void preview(core::Edit edit);
    void clearPreview();
    bool hasPreview() const { return !m_preview.empty(); }

    /// True while something that was done is not in the file yet: a large edit is being written, or writing failed and
    /// is tried again.
    bool hasUnsaved() const { return !m_pending.empty(); }
    /// True while a large edit reaches annotations() slice by slice.
    bool isApplying() const { return m_slices.has_value(); }
    /// True while that, or its writing, is under way.
    bool isBusy() const { return m_slices.has_value() || m_writing; }
    /// While it is, how much of that is done, 0 to 1.
    double busyShare() const;
    /// Tries at once and waits; true if everything is in the file now.
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
    /// A large edit gets under way, or is done.
    void busyChanged();
    /// busyShare() has changed.
    void busyProgressed();
    void saveFailed(const QString& message);
    /// An edit was not made, and why.
    void refused(const QString& message);

private:
    /// What is to be done to the file.
    struct StoreWork {
        StoreCall call;
        bool isLarge = false;
    };
    /// How far large work is, and how it ended; written by its thread.
    struct Outcome {
        std::atomic<double> written = 0;
        std::exception_ptr problem;
    };

    void restoreHistory(const core::AnnotationHistory& history);
    void applyToSet(const core::Edit& edit);
    void perform(const std::shared_ptr<const core::Edit>& edit, EditDirection direction, StoreCall call) override;
    void applySlices();
    void finishSlices();
    /// What a new edit starts from is in the set, and it starts from there.
    core::Edit rebased(core::Edit edit);
    void writePending();
    void writeLarge();
    void endLarge();
    void settle();

    std::unique_ptr<core::AnnotationStore> m_store;
    core::AnnotationSet m_set;
    core::Edit m_preview;
    QUndoStack m_undoStack;
    std::string m_rater = "annotator";
    std::deque<StoreWork> m_pending;
    bool m_writing = false; ///< the first one, on m_writer: nobody else touches the store
    std::shared_ptr<Outcome> m_outcome;
    mutable QThreadPool m_writer;
    mutable std::map<std::string, std::string> m_settings; ///< that were asked for or set
    std::optional<EditSlices> m_slices;                    ///< of a large edit that is not all in the set yet
    QTimer m_nextSlice;
    QTimer m_retry;
    QDateTime m_lastSaved;
    bool m_isOpen = false;
    bool m_restoring = false;
};

} // namespace widgets
