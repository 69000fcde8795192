// SPDX-License-Identifier: MIT
#include "widgets/jobs/subject_study.h"

#include "core/io/dataset/derived_dataset.h"

namespace widgets {

namespace {

QString subjectStageText(core::SubjectStage stage) {
    switch (stage) {
    case core::SubjectStage::ReadingAnnotations:
        return SubjectStudy::tr("reading annotations");
    case core::SubjectStage::ReadingMasks:
        return SubjectStudy::tr("reading masks");
    case core::SubjectStage::Measuring:
        break;
    }
    return SubjectStudy::tr("measuring");
}

} // namespace

SubjectStudy::SubjectStudy(JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_count(pool)
    , m_job(pool)
    , m_save(pool) {
    for (const Job* job : {&m_count, &m_job, &m_save})
        connect(job, &Job::failed, this, &SubjectStudy::failed);
    connect(&m_job, &Job::progressed, this, &SubjectStudy::progressed);
    for (const Job* job : {&m_job, &m_save}) {
        for (const auto end : {&Job::started, &Job::finished, &Job::stopped})
            connect(job, end, this, &SubjectStudy::runningChanged);
        connect(job, &Job::failed, this, &SubjectStudy::runningChanged);
    }
}

void SubjectStudy::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    for (Job* job : {&m_count, &m_job, &m_save})
        job->stop();
    m_dataset = std::move(dataset);
    m_sources.clear();
    m_result.reset();
    emit sourcesChanged();
    emit measured();
}

void SubjectStudy::count() {
    if (!m_dataset)
        return;
    m_count.start([this, dataset = m_dataset](const JobContext& context) -> Job::Delivery {
        std::vector<SubjectSource> sources;
        for (const core::Sequence& sequence : dataset->sequences) {
            if (context.stop.stop_requested())
                return {};
            sources.push_back({sequence.name, core::countSubjectFrames(*dataset, sequence), core::hasMasks(sequence)});
        }
        return [this, sources] {
            m_sources = sources;
            emit sourcesChanged();
        };
    });
}

void SubjectStudy::measure(const core::SubjectRequest& request) {
    if (!m_dataset || isMeasuring())
        return;
    m_result.reset();
    emit measured();
    m_job.start([this, dataset = m_dataset, request](const JobContext& context) -> Job::Delivery {
        const auto progress = [&context](core::SubjectStage stage, double fraction) {
            context.report(fraction, subjectStageText(stage));
        };
        auto result = std::make_shared<const core::MeasuredSubject>(
            core::measureSubject(*dataset, request, progress, context.stop));
        if (result->result.stopped)
            return {};
        return [this, result] {
            m_result = result;
            emit measured();
        };
    });
}

void SubjectStudy::stop() {
    m_job.stop();
}

void SubjectStudy::save(const QString& folder) {
    if (!m_result || isSaving())
        return;
    m_save.start([this, folder, original = m_dataset, result = m_result](const JobContext&) -> Job::Delivery {
        core::writeDerivedDataset(*original, result->dataset, folder.toStdString());
        return [this, folder] { emit saved(folder); };
    });
}

} // namespace widgets
