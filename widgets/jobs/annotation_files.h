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

    /// `kind` is one of core::annotationFormats().
    void exportTo(const QString& kind, const QString& path);
    void importFrom(const QString& kind, const QString& path);
    /// A page about the annotations of all sequences; joints above `badRmsPx` count as bad.
    void report(const QString& path, double badRmsPx);
    /// Reads a list of joints of one hand.
    void readJoints(const QString& path);
    bool isRunning() const { return m_job.isRunning(); }

signals:
    void exported(const QString& path);
    /// `warnings` say what was left out, one a line.
    void imported(const QString& path, int marks, const QString& warnings);
    void reported(const QString& path);
    void jointsRead(const std::vector<std::string>& names);
    void failed(const QString& message);

private:
    AnnotationDocument& m_document;
    const DatasetSession& m_session;
    Job m_job;
};

} // namespace widgets
