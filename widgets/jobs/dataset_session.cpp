// SPDX-License-Identifier: MIT
#include "widgets/jobs/dataset_session.h"

#include "core/error.h"

namespace widgets {

/// What a worker has read.
struct DatasetSession::Loaded {
    std::shared_ptr<const core::Dataset> dataset;
    const core::Sequence* sequence = nullptr;
    std::shared_ptr<const core::Motion> motion;
    AnnotationDocument::Content annotations;
};

DatasetSession::DatasetSession(AnnotationDocument& document, JobPool& pool, QObject* parent)
    : QObject(parent), m_document(document), m_job(pool) {
    connect(&m_job, &Job::failed, this, &DatasetSession::openFailed);
}

void DatasetSession::openDataset(const QString& folder, const QString& sequence, int frame) {
    load(nullptr, folder, sequence, frame);
}

void DatasetSession::openSequence(const QString& sequence, int frame) {
    if (!m_dataset)
        return;
    if (m_sequence && m_document.isOpen() && m_sequence->name == sequence.toStdString())
        m_job.stop();
    else
        load(m_dataset, {}, sequence, frame);
}

void DatasetSession::load(std::shared_ptr<const core::Dataset> dataset, const QString& folder, const QString& sequence,
                          int frame) {
    const auto folderPath = std::filesystem::path(folder.toStdString());
    if (!dataset && m_dataset && m_dataset->folder == folderPath)
        m_document.close(); // one process holds one writer per file: the old one lets go before the file is opened again
    emit opening(dataset ? sequence : folder);
    m_job.start([this, dataset, folderPath, name = sequence.toStdString(), frame](const JobContext&) -> Job::Delivery {
        auto loaded = std::make_shared<Loaded>();
        loaded->dataset = dataset ? dataset : std::make_shared<const core::Dataset>(core::readDataset(folderPath));
        if (loaded->dataset->sequences.empty())
            throw core::Error(core::ErrorCode::BadInput, (folderPath / "dataset.json").string(), "sequences",
                              "the dataset has no sequence");
        loaded->sequence = name.empty() ? &loaded->dataset->sequences.front() : &loaded->dataset->sequence(name);
        loaded->motion = std::make_shared<const core::Motion>(core::readMotion(*loaded->dataset, *loaded->sequence));
        loaded->annotations = AnnotationDocument::read(loaded->dataset->folder / loaded->sequence->annotations);
        return [this, loaded, frame] { take(loaded, frame); };
    });
}

void DatasetSession::take(const std::shared_ptr<Loaded>& loaded, int frame) {
    const bool isNew = m_dataset != loaded->dataset;
    m_dataset = loaded->dataset;
    m_sequence = loaded->sequence;
    m_motion = loaded->motion;
    if (isNew)
        emit datasetOpened();
    m_document.open(std::move(loaded->annotations));
    emit sequenceOpened(frame);
}

} // namespace widgets
