// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QObject>
#include <QStringList>

#include "core/geometry/camera.h"
#include "widgets/document/selection.h"
#include "widgets/jobs/job.h"
#include "widgets/session/dataset_session.h"

namespace widgets {

/// The calibrations of the open dataset, and which of them it uses. A new one is written beside the old one, which
/// stays: choosing the old one again undoes the change. Annotations, their file and their undo stack are not touched.
class CalibrationChoice : public QObject {
    Q_OBJECT

public:
    CalibrationChoice(DatasetSession& session, const Selection& selection, JobPool& pool, QObject* parent = nullptr);

    /// The cameras files that the dataset could use, relative to its folder; the one in use is among them.
    const QStringList& files() const { return m_files; }
    /// Empty before a dataset is open.
    QString inUse() const;
    /// Looks for the files; listed() follows.
    void list();
    /// Adds a calibration to the dataset and uses it; used() or failed() follows.
    void add(const std::vector<core::Camera>& cameras);
    /// Uses one of the files; used() or failed() follows.
    void use(const QString& file);
    bool isRunning() const { return m_job.isRunning(); }

signals:
    void listed();
    /// The dataset uses this file now, and everything was reconstructed anew.
    void used(const QString& file);
    /// Nothing has changed, and why.
    void failed(const QString& message);

private:
    void change(std::function<core::Dataset(const std::filesystem::path& folder)> write);

    DatasetSession& m_session;
    const Selection& m_selection;
    Job m_job;
    Job m_listing;
    QStringList m_files;
};

} // namespace widgets
