// SPDX-License-Identifier: MIT
#include "widgets/jobs/annotation_files.h"

#include <memory>

#include "core/annotation/edits.h"
#include "core/io/annotation_formats.h"
#include "core/io/annotation_report.h"
#include "core/io/joint_files.h"

namespace widgets {

AnnotationFiles::AnnotationFiles(AnnotationDocument& document, const DatasetSession& session, JobPool& pool, QObject* parent)
    : QObject(parent), m_document(document), m_session(session), m_job(pool) {
    connect(&m_job, &Job::failed, this, &AnnotationFiles::failed);
}

void AnnotationFiles::exportTo(const QString& kind, const QString& path) {
    if (!m_session.sequence()) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    m_job.start([this, kind, path, dataset = m_session.dataset(), sequence = *m_session.sequence(),
                 set = m_document.annotations()](const JobContext&) -> Job::Delivery {
        core::exportAnnotations(*dataset, sequence, set, kind.toStdString(), path.toStdString());
        return [this, path] { emit exported(path); };
    });
}

void AnnotationFiles::importFrom(const QString& kind, const QString& path) {
    if (!m_session.sequence()) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    m_job.start([this, kind, path, dataset = m_session.dataset(), sequence = *m_session.sequence(),
                 rater = m_document.rater()](const JobContext&) -> Job::Delivery {
        core::AnnotationImportOptions options;
        options.rater = rater;
        auto read = std::make_shared<const core::ImportedAnnotations>(
            core::importAnnotations(*dataset, sequence, kind.toStdString(), path.toStdString(), options));
        return [this, path, read] {
            m_document.push(core::importEdit(m_document.annotations(), read->set, "import " + path.toStdString()));
            QStringList warnings;
            for (const std::string& warning : read->warnings)
                warnings << QString::fromStdString(warning);
            emit imported(path, static_cast<int>(read->set.marks.size()), warnings.join(QLatin1Char('\n')));
        };
    });
}

void AnnotationFiles::report(const QString& path, double badRmsPx) {
    if (!m_session.dataset()) {
        emit failed(tr("Open a dataset first."));
        return;
    }
    m_job.start([this, path, badRmsPx, dataset = m_session.dataset()](const JobContext&) -> Job::Delivery {
        core::writeAnnotationReport(*dataset, path.toStdString(), badRmsPx);
        return [this, path] { emit reported(path); };
    });
}

void AnnotationFiles::readJoints(const QString& path) {
    m_job.start([this, path](const JobContext&) -> Job::Delivery {
        return [this, names = core::readJointList(path.toStdString())] { emit jointsRead(names); };
    });
}

} // namespace widgets
