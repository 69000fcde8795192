// SPDX-License-Identifier: MIT
#include "widgets/session/annotation_files.h"

#include <utility>

#include "core/io/dataset/dataset_rig.h"
#include "core/io/formats/annotation_report.h"
#include "core/io/formats/joint_files.h"
#include "widgets/text/import_text.h"

namespace widgets {

AnnotationFiles::AnnotationFiles(AnnotationDocument& document, const DatasetSession& session, JobPool& pool,
                                 QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_session(session)
    , m_job(pool) {
    connect(&m_job, &Job::failed, this, &AnnotationFiles::failed);
    connect(
        &m_job, &Job::started, this, [this] { emit working(m_task, -1); });
    connect(&m_job, &Job::progressed, this, [this](double fraction) { emit working(m_task, fraction); });
    for (const auto end : {&Job::finished, &Job::stopped})
        connect(&m_job, end, this, &AnnotationFiles::idle);
    connect(&m_job, &Job::failed, this, &AnnotationFiles::idle);
    connect(&document, &AnnotationDocument::aboutToClose, this,
            [this] { // an import is for the sequence that it was asked for
                cancelImport();
                if (m_job.isRunning() && m_isImport) {
                    m_job.stop();
                    emit failed(tr("The import was stopped, because another sequence was opened."));
                }
            });
}

bool AnnotationFiles::isRefused() {
    if (!m_session.sequence()) {
        emit failed(tr("Open a dataset first."));
        return true;
    }
    if (m_job.isRunning()) {
        emit failed(tr("One moment: the last import, export or report is not finished."));
        return true;
    }
    return false;
}

void AnnotationFiles::start(const QString& task, bool isImport, Job::Work work) {
    m_task = task;
    m_isImport = isImport;
    m_job.start(std::move(work));
}

void AnnotationFiles::exportTo(const QString& kind, const QString& path) {
    if (isRefused())
        return;
    start(tr("Exporting"), false,
          [this, kind, path, dataset = m_session.dataset(), sequence = *m_session.sequence(),
           set = m_document.annotations(), rater = m_document.rater()](const JobContext&) -> Job::Delivery {
              core::AnnotationExportOptions options;
              options.sigmas = core::datasetClickSigmas(*dataset);
              if (!core::annotationFormat(kind.toStdString()).namesRaters)
                  options.rater = rater;
              core::exportAnnotations(*dataset, sequence, set, kind.toStdString(), path.toStdString(), options);
              return [this, path] { emit exported(path); };
          });
}

void AnnotationFiles::importFrom(const QString& kind, const QString& path, const QStringList& videos) {
    if (isRefused())
        return;
    cancelImport();
    start(tr("Importing"), true,
          [this, kind, path, videos, dataset = m_session.dataset(), sequence = *m_session.sequence(),
           rater = m_document.rater()](const JobContext&) -> Job::Delivery {
              core::AnnotationImportOptions options;
              options.rater = rater;
              for (const QString& video : videos)
                  options.videos.push_back(video.toStdString());
              auto read = std::make_shared<const core::ImportedAnnotations>(
                  core::importAnnotations(*dataset, sequence, kind.toStdString(), path.toStdString(), options));
              return [this, kind, path, read] { takeImport(kind, path, read); };
          });
}

void AnnotationFiles::takeImport(const QString& kind, const QString& path,
                                 std::shared_ptr<const core::ImportedAnnotations> read) {
    const bool isEmpty = read->set.marks.empty() && read->set.notes.empty();
    if (isEmpty && read->unknownParts.empty() && !read->otherVideos.empty()) {
        QStringList videos;
        for (const std::string& video : read->otherVideos)
            videos << QString::fromStdString(video);
        emit otherVideosFound(kind, path, videos);
        return;
    }
    const core::ImportConflicts conflicts = core::importConflicts(m_document.annotations(), read->set);
    m_waiting = WaitingImport{path, std::move(read)};
    if (conflicts.empty())
        finishImport(core::ImportMode::Replace);
    else
        emit importConflicts(path, conflicts);
}

void AnnotationFiles::finishImport(core::ImportMode mode) {
    if (!m_waiting)
        return;
    const WaitingImport import = *std::exchange(m_waiting, std::nullopt);
    core::Edit edit = core::importEdit(m_document.annotations(), import.read->set, import.path.toStdString(), mode);
    const auto marks = static_cast<int>(edit.marks.size()), notes = static_cast<int>(edit.notes.size());
    m_document.push(std::move(edit));
    if (m_document.isReadOnly()) // and it has said so
        return;
    emit imported(import.path, marks, notes, importNotesInWords(import.read->warnings).join(QLatin1Char('\n')));
}

void AnnotationFiles::cancelImport() {
    if (std::exchange(m_waiting, std::nullopt))
        emit importCancelled();
}

void AnnotationFiles::report(const QString& path, double badRmsPx) {
    if (isRefused())
        return;
    start(tr("Writing the report"), false,
          [this, path, badRmsPx, dataset = m_session.dataset()](const JobContext& context) -> Job::Delivery {
              core::writeAnnotationReport(
                  *dataset, path.toStdString(), {badRmsPx, {}}, context.stop,
                  [&context](int done, int total) { context.report(double(done) / total, {}); });
              return [this, path] { emit reported(path); };
          });
}

void AnnotationFiles::readJoints(const QString& path) {
    if (isRefused())
        return;
    start(tr("Reading the joints"), false, [this, path](const JobContext&) -> Job::Delivery {
        return [this, names = core::readJointList(path.toStdString())] { emit jointsRead(names); };
    });
}

} // namespace widgets
