// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include "widgets/document/selection.h"
#include "widgets/jobs/job.h"
#include "widgets/session/dataset_session.h"

namespace widgets {

/// Gives the open sequence masks from a folder, in the background: the dataset's file is rewritten and read again, at
/// the same frame.
class MaskAttacher : public QObject {
    Q_OBJECT

public:
    MaskAttacher(DatasetSession& session, const Selection& selection, JobPool& pool, QObject* parent = nullptr);

    void attach(const QString& folder);

signals:
    /// `notes` says what was found; the dataset is being opened again.
    void attached(const QString& notes);
    void failed(const QString& message);

private:
    DatasetSession& m_session;
    const Selection& m_selection;
    Job m_job;
};

} // namespace widgets
