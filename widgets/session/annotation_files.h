// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "core/annotation/import_edit.h"
#include "core/io/formats/annotation_formats.h"
#include "widgets/document/annotation_document.h"
#include "widgets/jobs/job.h"
#include "widgets/session/dataset_session.h"

namespace widgets {

/// Exports and imports the annotations of the open sequence, writes reports and reads lists of joints, in the
/// background. An import is one edit.
class AnnotationFiles : public QObject {
    Q_OBJECT

public:
    AnnotationFiles(AnnotationDocument& document, const DatasetSession& session, JobPool& pool,
                    QObject* parent = nullptr);

    /// `kind` is one of core::annotationFormats(). Formats that hold one rater get the current one. One task at a time:
    /// another is refused.
    void exportTo(const QString& kind, const QString& path);
    /// Formats that name no rater bring marks of the current one. Ends with imported() or failed(), or asks: with
    /// importConflicts() if marks or notes of the same raters would be replaced, with otherVideosFound() if the labels
    /// are of other videos. `videos`: whose labels are wanted though the sequence is called otherwise.
    void importFrom(const QString& kind, const QString& path, const QStringList& videos = {});
    /// Answers importConflicts().
    void finishImport(core::ImportMode mode);
    void cancelImport();
    /// A page about the annotations of all sequences; joints above `badRmsPx` count as bad.
    void report(const QString& path, double badRmsPx);
    /// Reads a list of joints of one hand.
    void readJoints(const QString& path);
    bool isRunning() const { return m_job.isRunning(); }
    void stop() { m_job.stop(); }

signals:
    /// How far the task is; a fraction below 0 if it is unknown. Then idle().
    void working(const QString& task, double fraction);
    void idle();
    void exported(const QString& path);
    /// How many marks and notes changed; `warnings` say what was left out, one a line.
    void imported(const QString& path, int marks, int notes, const QString& warnings);
    /// Nothing is imported before finishImport().
    void importConflicts(const QString& path, const core::ImportConflicts& conflicts);
    /// Nothing was imported: the labels are of these videos. An import that wants them takes them.
    void otherVideosFound(const QString& kind, const QString& path, const QStringList& videos);
    /// An import that waited for an answer was given up.
    void importCancelled();
    void reported(const QString& path);
    void jointsRead(const std::vector<std::string>& names);
    void failed(const QString& message);

private:
    /// True, and why is said, if unknown sequence or something is still running.
    bool isRefused();
    void start(const QString& task, bool isImport, Job::Work work);

    /// Takes over what was read, or asks first.
    void takeImport(const QString& kind, const QString& path, std::shared_ptr<const core::ImportedAnnotations> read);

    /// An import that waits for an answer.
    struct WaitingImport {
        QString path;
        std::shared_ptr<const core::ImportedAnnotations> read;
    };

    AnnotationDocument& m_document;
    const DatasetSession& m_session;
    Job m_job;
    QString m_task;          ///< that is running, for people
    bool m_isImport = false; ///< it changes the annotations
    std::optional<WaitingImport> m_waiting;
};

} // namespace widgets
