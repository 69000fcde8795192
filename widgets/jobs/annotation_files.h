// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "widgets/document/annotation_document.h"
#include "widgets/jobs/dataset_session.h"
#include "widgets/jobs/job.h"

namespace widgets {

/// Exports and imports the annotations of the open sequence, writes reports and reads lists of joints, in the background. An import
/// is one edit.
class AnnotationFiles : public QObject {
    Q_OBJECT

public:
    AnnotationFiles(AnnotationDocument& document, const DatasetSession& session, JobPool& pool, QObject* parent = nullptr);

    /// `kind` is one of core::annotationFormats(). Formats that hold one rater get the current one. One task at a time: another is
    /// refused.
    void exportTo(const QString& kind, const QString& path);
    void importFrom(const QString& kind, const QString& path);
    /// A page about the annotations of all sequences; joints above `badRmsPx` count as bad.
    void report(const QString& path, double badRmsPx);
    /// Reads a list of joints of one hand.
    void readJoints(const QString& path);
    bool isRunning() const { return m_job.isRunning(); }
    void stop() { m_job.stop(); }

signals:
    /// How far the task is; a fraction below 0 if nobody knows. Then idle().
    void working(const QString& task, double fraction);
    void idle();
    void exported(const QString& path);
    /// `warnings` say what was left out, one a line.
    void imported(const QString& path, int marks, const QString& warnings);
    void reported(const QString& path);
    void jointsRead(const std::vector<std::string>& names);
    void failed(const QString& message);

private:
    /// True, and why is said, if there is no sequence or something is still running.
    bool isRefused();
    void start(const QString& task, bool isImport, Job::Work work);

    AnnotationDocument& m_document;
    const DatasetSession& m_session;
    Job m_job;
    QString m_task;          ///< that is running, for people
    bool m_isImport = false; ///< it changes the annotations
};

} // namespace widgets
