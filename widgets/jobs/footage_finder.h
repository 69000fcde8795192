// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QObject>
#include <QString>

#include "core/io/dataset/dataset.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// Looks in the background for footage that has moved, and keeps its new places in the dataset's file.
class FootageFinder : public QObject {
    Q_OBJECT

public:
    explicit FootageFinder(JobPool& pool, QObject* parent = nullptr);

    /// Looks below `root` for what `dataset` cannot find. found() or failed() follows.
    void find(const std::shared_ptr<const core::Dataset>& dataset, const QString& root);
    bool isRunning() const { return m_job.isRunning(); }
    void stop() { m_job.stop(); }

signals:
    void started();
    /// Nothing is under way any more: done, failed or stopped.
    void idle();
    /// How many pieces of footage of the dataset in `folder` have a new place. If any has, dataset.json says so now:
    /// the dataset is to be read again. `notes` say what does not fit and what was not found, one a line; empty if all
    /// is well.
    void found(const QString& folder, int pieces, const QString& notes);
    void failed(const QString& message);

private:
    Job m_job;
};

/// True if pictures of that camera cannot be there, because the video, or the folder of its images, does not exist.
bool isFootageGone(const core::Dataset& dataset, const core::Sequence& sequence, const std::string& camera);

} // namespace widgets
