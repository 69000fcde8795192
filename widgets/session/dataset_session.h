// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include <QObject>
#include <QString>

#include "core/io/dataset/dataset.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// The dataset and the sequence that are open. Both are read in the background; the ones before stay until that has
/// succeeded.
class DatasetSession : public QObject {
    Q_OBJECT

public:
    DatasetSession(AnnotationDocument& document, JobPool& pool, QObject* parent = nullptr);

    /// Reads a dataset, then opens `sequence` (its first one if that is empty) at `frame`.
    void openDataset(const QString& folder, const QString& sequence = {}, int frame = 0);
    /// Opens the demo in `folder`, where it is written first if it is not there.
    void openDemo(const QString& folder);
    /// Opens another sequence of the open dataset at `frame`; does nothing if it is open.
    void openSequence(const QString& sequence, int frame = 0);
    /// The same dataset with another calibration, as it stands in its file now: all views and joints follow, the
    /// annotations and their undo stack stay as they are. An opening that is under way is given up. datasetOpened() and
    /// sequenceOpened() follow.
    void takeCalibration(std::shared_ptr<const core::Dataset> changed, int frame);
    bool isOpening() const { return m_job.isRunning(); }

    /// Null before a dataset is open.
    const std::shared_ptr<const core::Dataset>& dataset() const { return m_dataset; }
    /// Null before a sequence is open.
    const core::Sequence* sequence() const { return m_sequence; }
    /// Recorded poses, one entry per frame; empty if there are none. Never null while a sequence is open.
    const std::shared_ptr<const core::Motion>& motion() const { return m_motion; }

signals:
    void opening(const QString& what);
    void datasetOpened();
    /// Emitted after datasetOpened, and after the document has its content.
    void sequenceOpened(int frame);
    /// What was open stays open (but for the annotations, if the same dataset was opened again).
    void openFailed(const QString& message);

private:
    struct Loaded;
    using DatasetReader = std::function<std::shared_ptr<const core::Dataset>()>;
    void load(DatasetReader reader, const QString& sequence, int frame);
    void closeBefore(const std::filesystem::path& folder);
    bool mayLeave();
    void take(const std::shared_ptr<Loaded>& loaded, int frame);

    AnnotationDocument& m_document;
    Job m_job;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::shared_ptr<const core::Motion> m_motion;
    const core::Sequence* m_sequence = nullptr;
};

} // namespace widgets
