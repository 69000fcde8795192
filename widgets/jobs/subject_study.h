// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QString>

#include "core/io/derived/measured_subject.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// A sequence that a person's hands may be measured from.
struct SubjectSource {
    std::string sequence;
    int annotatedFrames = 0; ///< that a measurement could use
    bool hasMasks = false;
};

/// Measures the hands of the person whose joints are annotated in the open dataset, and makes a new dataset with them,
/// in the background.
class SubjectStudy : public QObject {
    Q_OBJECT

public:
    explicit SubjectStudy(JobPool& pool, QObject* parent = nullptr);

    /// Another dataset: what was measured is forgotten.
    void setDataset(std::shared_ptr<const core::Dataset> dataset);
    const std::shared_ptr<const core::Dataset>& dataset() const { return m_dataset; }

    /// Counts the annotated frames of every sequence as they stand in the files now; sourcesChanged() follows.
    void count();
    const std::vector<SubjectSource>& sources() const { return m_sources; }

    /// measured() or failed() follows.
    void measure(const core::SubjectRequest& request);
    void stop();
    bool isMeasuring() const { return m_job.isRunning(); }
    /// Null if nothing was measured yet.
    const std::shared_ptr<const core::MeasuredSubject>& result() const { return m_result; }

    /// Writes the dataset with the measured hands into a new or empty folder; saved() or failed() follows.
    void save(const QString& folder);
    bool isSaving() const { return m_save.isRunning(); }

signals:
    void sourcesChanged();
    /// `fraction` is below 0 where it is unknown.
    void progressed(double fraction, const QString& stage);
    void runningChanged();
    /// There is a new result, or none any more.
    void measured();
    void saved(const QString& folder);
    void failed(const QString& message);

private:
    Job m_count;
    Job m_job;
    Job m_save;
    std::shared_ptr<const core::Dataset> m_dataset;
    std::vector<SubjectSource> m_sources;
    std::shared_ptr<const core::MeasuredSubject> m_result;
};

} // namespace widgets
